#include "common/geometry/general_solid.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "common/geometry/triangle_distance.h"

namespace trocar {

GeneralSolid::GeneralSolid(const SolidMesh& solid) : solid_(solid), surface_(solid.mesh) {}

bool GeneralSolid::contains(const Vec3& point) const {
    return solid_.box.contains(point) && surface_.contains(point);
}

double GeneralSolid::exit_distance(const Vec3& point, const Vec3& direction, double clearance) const {
    std::vector<Interval> near;
    for (const Index facet : surface_.facets_along(point, direction, clearance)) {
        const Interval stretch = stretch_near(point, direction, solid_.corners(facet), clearance);
        if (!stretch.empty() && stretch.end > 0) near.push_back(stretch);
    }
    std::ranges::sort(near, {}, &Interval::begin);
    double reached = 0;
    for (auto next = near.begin(); next != near.end(); reached = next++->end) {
        for (; next != near.end() && next->begin < reached; ++next) reached = std::max(reached, next->end);
        // Here the surface is at the clearance or further: outside this is the exit, inside the line goes on
        // until it meets the surface again.
        if (next == near.end() || !contains(point + reached * direction)) break;
    }
    return reached;
}

SurfacePoint GeneralSolid::closest(const Vec3& point) const {
    SurfacePoint found = surface_.closest(point, solid_.rounding);
    found.normal = solid_.faces[solid_.face_of[found.facet]].normal;
    return found;
}

bool GeneralSolid::crossed_by(const Corners& organ_facet) const {
    Box box;
    for (const Vec3& corner : organ_facet) box.add(corner);
    return std::ranges::any_of(surface_.facets_near(box), [&](Index facet) {
        return facets_cross(organ_facet, solid_.corners(facet), solid_.flat_edges[facet]);
    });
}

void GeneralSolid::check_not_self_intersecting() const {
    const auto pair = surface_.self_intersection();
    if (!pair) return;
    throw std::invalid_argument("a solid's surface must not meet itself; facets " +
                                std::to_string(pair->at(0)) + " and " + std::to_string(pair->at(1)) +
                                " (counted from 0) of this mesh do");
}

}  // namespace trocar
