#include "common/geometry/general_solid.h"

#include <stdexcept>
#include <string>

#include "common/geometry/closest_search.h"
#include "common/geometry/exit_search.h"
#include "common/geometry/inside_test.h"

namespace trocar {
namespace {

/// Whether a facet crosses one of the solid's. A search of a FacetTree.
struct CrossingSearch {
    const SolidMesh& solid;
    const Corners& organ_facet;
    Box box;
    bool crosses = false;

    [[nodiscard]] double key(const Box& other) const { return box.overlaps(other) ? 0 : 1; }
    [[nodiscard]] double limit() const { return crosses ? -1 : 0; }
    void visit(const FacetTree::Item& item) {
        crosses = crosses || facets_cross(organ_facet, item.corners, solid.flat_edges[item.facet]);
    }
};

}  // namespace

GeneralSolid::GeneralSolid(const SolidMesh& solid) : solid_(solid), tree_(solid.mesh) {}

bool GeneralSolid::contains(const Vec3& point) const {
    return solid_.box.contains(point) && is_inside(tree_, point);
}

double GeneralSolid::exit_distance(const Vec3& point, const Vec3& direction, double clearance) const {
    return trocar::exit_distance(tree_, point, direction, clearance, solid_.rounding);
}

SurfacePoint GeneralSolid::closest(const Vec3& point) const {
    const auto [position, facet] = closest_facet(tree_, point, solid_.rounding);
    return {.position = position, .facet = facet, .normal = solid_.faces[solid_.face_of[facet]].normal};
}

bool GeneralSolid::crossed_by(const Corners& organ_facet) const {
    CrossingSearch search{.solid = solid_, .organ_facet = organ_facet, .box = {}};
    for (const Vec3& corner : organ_facet) search.box.add(corner);
    tree_.walk(search);
    return search.crosses;
}

void GeneralSolid::check_not_self_intersecting() const {
    const auto pair = self_intersection(solid_.mesh);
    if (!pair) return;
    throw std::invalid_argument("a solid's surface must not meet itself; facets " +
                                std::to_string(pair->at(0)) + " and " + std::to_string(pair->at(1)) +
                                " (counted from 0) of this mesh do");
}

}  // namespace trocar
