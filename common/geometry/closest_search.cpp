#include "common/geometry/closest_search.h"

#include <algorithm>
#include <limits>

#include "common/geometry/triangle_distance.h"

namespace trocar {
namespace {

double square(double x) { return x * x; }

/// How near the surface is. Searches of a FacetTree, the keys of which are squared distances.
struct Least {
    const Vec3& point;
    double rounding;
    double least = std::numeric_limits<double>::infinity();

    [[nodiscard]] double key(const Box& box) const { return box.squared_distance(point); }
    [[nodiscard]] double limit() const { return square(least + rounding); }
    void visit(const FacetTree::Item& item) {
        least = std::min(least, (closest_on_triangle(point, item.corners) - point).norm());
    }
};

/// The facet of lowest number that is no further away than `reach` (mm).
struct Lowest {
    const Vec3& point;
    double reach;
    ClosestFacet found{.position = {}, .facet = std::numeric_limits<Index>::max()};

    [[nodiscard]] double key(const Box& box) const { return box.squared_distance(point); }
    [[nodiscard]] double limit() const { return square(reach) * (1 + 1e-12); }  // keys are rounded
    void visit(const FacetTree::Item& item) {
        if (item.facet >= found.facet) return;
        const Vec3 position = closest_on_triangle(point, item.corners);
        if ((position - point).norm() <= reach) found = {position, item.facet};
    }
};

}  // namespace

ClosestFacet closest_facet(const FacetTree& tree, const Vec3& point, double rounding) {
    Least nearest{point, rounding};
    tree.walk(nearest);
    Lowest lowest{point, nearest.least + rounding};
    tree.walk(lowest);
    return lowest.found;
}

}  // namespace trocar
