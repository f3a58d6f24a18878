#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "common/geometry/predicates.h"

namespace trocar {

/// What is left of a facet when planes along z have cut it: a convex polygon.
class FacetPiece {
  public:
    explicit FacetPiece(const Corners& facet) : count_(facet.size()) {
        std::ranges::copy(facet, corners_.begin());
    }

    [[nodiscard]] std::span<const Vec3> corners() const { return {corners_.data(), count_}; }

    /// Cuts off where `value`, a linear function of the point, is negative. At most four times.
    template <typename Linear>
    void cut(Linear value) {
        std::array<Vec3, most_corners> left;
        std::size_t count = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            const Vec3 &here = corners_[k], &next = corners_[k + 1 < count_ ? k + 1 : 0];
            const double value_here = value(here), value_next = value(next);
            if (value_here >= 0) left[count++] = here;
            if ((value_here < 0) == (value_next < 0)) continue;
            left[count++] = here + (next - here) * (value_here / (value_here - value_next));
        }
        std::copy_n(left.begin(), count, corners_.begin());
        count_ = count;
    }

    /// The integral of a linear function of the point over the piece's shadow in the plane of x and y,
    /// negative where the facet faces −z.
    template <typename Linear>
    [[nodiscard]] double integral(Linear value) const {
        double sum = 0;
        for (std::size_t k = 2; k < count_; ++k) {
            const Vec3 &a = corners_[0], &b = corners_[k - 1], &c = corners_[k];
            const double area = ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / 2;
            sum += area * (value(a) + value(b) + value(c)) / 3;
        }
        return sum;
    }

  private:
    // A cut of n corners leaves at most 3n/2, also when rounding has made the polygon not quite convex:
    // 3, 4, 6, 9, 13.
    static constexpr std::size_t most_corners = 13;

    std::array<Vec3, most_corners> corners_;
    std::size_t count_;
};

}  // namespace trocar
