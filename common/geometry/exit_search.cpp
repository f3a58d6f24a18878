#include "common/geometry/exit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/inside_test.h"
#include "common/geometry/triangle_distance.h"

namespace trocar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The line on which the exit lies, and how near the surface may not be there.
struct Way {
    const Vec3 &point, &direction;
    double clearance;
    double reach;  ///< the clearance, and a bit more than rounding

    [[nodiscard]] Vec3 at(double t) const { return point + t * direction; }
    [[nodiscard]] Interval near(const Corners& facet) const {
        return stretch_near(point, direction, facet, clearance);
    }
};

/// Goes on along the line from a place for as long as the facets there are nearer than the clearance. A
/// search of a FacetTree.
struct Leave {
    const Way& way;
    double reached;
    Vec3 place = way.at(reached);

    [[nodiscard]] double key(const Box& box) const { return box.squared_distance(place); }
    [[nodiscard]] double limit() const { return way.reach * way.reach; }
    void visit(const FacetTree::Item& item) {
        if ((closest_on_triangle(place, item.corners) - place).squaredNorm() > limit()) return;
        const Interval near = way.near(item.corners);
        if (near.begin < reached && near.end > reached) {
            reached = near.end;
            place = way.at(reached);
        }
    }
};

/// Finds the first stretch beyond a place in which a facet is nearer than the clearance. A search of a
/// FacetTree, the keys of which are places on the line.
class Meet {
  public:
    Meet(const Way& way, double from) : way_(way), from_(from) {
        for (int k = 0; k < 3; ++k) inverse_[k] = 1 / way.direction[k];
    }

    [[nodiscard]] const Interval& first() const { return first_; }

    [[nodiscard]] double key(const Box& box) const {
        const Vec3 low = (box.low - way_.point).array() - way_.reach;
        const Vec3 high = (box.high - way_.point).array() + way_.reach;
        double begin = from_, end = infinity;
        for (int k = 0; k < 3; ++k) {
            if (std::isinf(inverse_[k])) {
                if (low[k] > 0 || high[k] < 0) return infinity;
                continue;
            }
            const double one = low[k] * inverse_[k], other = high[k] * inverse_[k];
            begin = std::max(begin, std::min(one, other));
            end = std::min(end, std::max(one, other));
        }
        return begin <= end ? begin : infinity;
    }
    [[nodiscard]] double limit() const { return std::min(first_.begin, largest); }
    void visit(const FacetTree::Item& item) {
        const Interval near = way_.near(item.corners);
        if (!near.empty() && near.begin >= from_ && near.begin < first_.begin) first_ = near;
    }

  private:
    static constexpr double largest = std::numeric_limits<double>::max();

    const Way& way_;
    double from_;
    Vec3 inverse_;
    Interval first_;
};

}  // namespace

double exit_distance(const FacetTree& tree, const Vec3& point, const Vec3& direction, double clearance,
                     double rounding) {
    const Way way{point, direction, clearance, clearance + rounding};
    double reached = 0;
    while (true) {
        Leave leave{way, reached};
        tree.walk(leave);
        if (leave.reached > reached) {
            reached = leave.reached;
            continue;  // what is near there was too far away before
        }
        // Here the surface is at the clearance or further: outside this is the exit, inside the line goes on
        // until it meets the surface again.
        if (!tree.box().contains(leave.place) || !is_inside(tree, leave.place)) return reached;
        Meet meet(way, reached);
        tree.walk(meet);
        if (meet.first().empty()) return reached;
        reached = meet.first().end;
    }
}

}  // namespace trocar
