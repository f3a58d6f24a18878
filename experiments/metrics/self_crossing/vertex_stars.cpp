#include "experiments/metrics/self_crossing/vertex_stars.h"

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Geometry>

namespace trocar {
namespace {

/// Sines of angles below this are taken for none: far above rounding, far below any angle of a sound mesh.
constexpr double least_sine = 1e-9;

/// Spokes as they are seen along a direction: 1 where `b` is counter-clockwise of `a` by less than half a
/// turn, −1 where it is clockwise, 0 where that is not clear.
struct View {
    Vec3 along;  // unit

    [[nodiscard]] int turn(const Vec3& a, const Vec3& b) const {
        const double sine = along.dot(a.cross(b));
        const double clear = least_sine * a.norm() * b.norm();
        return sine > clear ? 1 : sine < -clear ? -1 : 0;
    }
    /// Whether it is seen too much from its end to tell well where it points.
    [[nodiscard]] bool steep(const Vec3& spoke) const {
        const double height = along.dot(spoke);
        return height * height > (1 - 1e-4) * spoke.squaredNorm();
    }
    /// Whether two spokes on one line point to the same side.
    [[nodiscard]] bool same_side(const Vec3& a, const Vec3& b) const {
        return a.dot(b) > along.dot(a) * along.dot(b);
    }
};

/// How often spokes that turn counter-clockwise pass the first one.
int passes(const View& view, std::span<const Vec3> spokes) {
    int passed = 0;
    bool below = false;
    for (const Vec3& spoke : spokes) {
        const bool below_now = view.along.dot(spokes.front().cross(spoke)) < 0;
        if (below && !below_now) ++passed;
        below = below_now;
    }
    return passed;
}

/// Of spokes that all turn counter-clockwise.
bool goes_round_once(const View& view, std::span<const Vec3> spokes, bool closed) {
    if (passes(view, spokes) > 0) return false;
    const int closing = view.turn(spokes.back(), spokes.front());
    if (closed) return closing > 0;
    return closing != 0 || !view.same_side(spokes.front(), spokes.back());
}

}  // namespace

VertexStars::VertexStars(const Organ& organ) {
    for (Index vertex = 0; vertex < static_cast<Index>(organ.rest.positions.size()); ++vertex) {
        add_star(organ, vertex);
    }
}

void VertexStars::add_star(const Organ& organ, Index vertex) {
    std::vector<std::array<Index, 2>> sides;  // of each facet around it: the spokes on its right and left
    for (const Index facet : organ.adjacency.ring(vertex)) {
        const Facet& corners = organ.rest.facets[facet];
        const auto k = std::ranges::find(corners, vertex) - corners.begin();
        sides.push_back({corners[(k + 1) % 3], corners[(k + 2) % 3]});
    }
    const auto first = static_cast<Index>(ends_.size());
    const bool closed = !organ.adjacency.on_boundary(vertex);
    const auto follows = [&](std::size_t k) {
        return sides[k][0] == sides[(k + sides.size() - 1) % sides.size()][1];
    };
    std::size_t begin = 0;
    while (!closed && begin < sides.size() && follows(begin)) ++begin;
    for (std::size_t k = 0; k < sides.size(); ++k) ends_.push_back(sides[(begin + k) % sides.size()][0]);
    if (!closed && !sides.empty()) ends_.push_back(sides[(begin + sides.size() - 1) % sides.size()][1]);
    stars_.push_back({first, static_cast<Index>(ends_.size()) - first, closed});
}

std::vector<Vec3> VertexStars::spokes(Index vertex, std::span<const Vec3> positions) const {
    const auto& [first, count, closed] = stars_[vertex];
    std::vector<Vec3> spokes;
    spokes.reserve(count);
    for (Index k = first; k < first + count; ++k) {
        spokes.emplace_back(positions[ends_[k]] - positions[vertex]);
    }
    return spokes;
}

std::optional<Vec3> VertexStars::unfolding(Index vertex, std::span<const Vec3> positions) const {
    const bool closed = stars_[vertex].closed;
    const std::vector<Vec3> spokes = this->spokes(vertex, positions);
    Vec3 mean = Vec3::Zero();
    for (std::size_t k = 0; k + 1 < spokes.size(); ++k) mean += spokes[k].cross(spokes[k + 1]);
    if (closed) mean += spokes.back().cross(spokes.front());
    const View view{mean.normalized()};
    for (std::size_t k = 0; k < spokes.size(); ++k) {
        if (view.steep(spokes[k])) return std::nullopt;
        if (k > 0 && view.turn(spokes[k - 1], spokes[k]) <= 0) return std::nullopt;
    }
    if (!goes_round_once(view, spokes, closed)) return std::nullopt;
    return view.along;
}

double VertexStars::freedom(Index vertex, std::span<const Vec3> positions) const {
    const std::optional<Vec3> along = unfolding(vertex, positions);
    if (!along) return 0;
    const View view{*along};
    const std::vector<Vec3> spokes = this->spokes(vertex, positions);
    double least = std::numeric_limits<double>::infinity();
    const auto add = [&](const Vec3& right, const Vec3& left) {
        const double longest = std::max({right.norm(), left.norm(), (left - right).norm()});
        least = std::min(least, view.along.dot(right.cross(left)) / longest / 2);
    };
    for (std::size_t k = 0; k + 1 < spokes.size(); ++k) add(spokes[k], spokes[k + 1]);
    // Beyond the facets of an open star its ends must not come to meet: the gap counts as one more facet,
    // unless it is half a turn or wider. Then no turn of two sides by less than a quarter each closes it.
    if (view.turn(spokes.back(), spokes.front()) > 0) add(spokes.back(), spokes.front());
    return least;
}

}  // namespace trocar
