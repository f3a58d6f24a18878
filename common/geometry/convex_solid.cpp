#include "common/geometry/convex_solid.h"

#include <algorithm>
#include <limits>

namespace trocar {
namespace {

/// Largest distance of a coordinate from the origin plus the solid's size: what rounding is relative to.
double extent(const SolidMesh& solid) {
    return solid.box.size().norm() + solid.box.low.cwiseAbs().cwiseMax(solid.box.high.cwiseAbs()).norm();
}

/// Bound (mm) of the error of a height over the face: that of its normal, which grows as the facets get
/// narrower, times the solid's extent.
double height_error(const SolidMesh& solid, const FlatFace& face) {
    double squares = 0;
    Vec3 area = Vec3::Zero();
    for (const Index facet : face.facets) {
        const Corners c = solid.corners(facet);
        squares += (c[1] - c[0]).squaredNorm() + (c[2] - c[0]).squaredNorm();
        area += facet_area_vector(solid.mesh.positions, solid.mesh.facets[facet]);
    }
    return extent(solid) * (1e-14 + 1e-14 * squares / area.norm());
}

int side_of_face(const SolidMesh& solid, const FlatFace& face, const Vec3& point) {
    const Corners plane = solid.corners(face.facets.front());
    return orientation_sign(plane[0], plane[1], plane[2], point);
}

}  // namespace

bool is_convex(const SolidMesh& solid) {
    return std::ranges::all_of(solid.faces, [&](const FlatFace& face) {
        const double sure = height_error(solid, face);
        const Vec3 on_face = solid.corners(face.facets.front())[0];
        return std::ranges::all_of(solid.mesh.positions, [&](const Vec3& position) {
            const double height = face.normal.dot(position - on_face);
            return height < -sure || (height <= sure && side_of_face(solid, face, position) <= 0);
        });
    });
}

ConvexSolid::ConvexSolid(const SolidMesh& solid) : solid_(solid) {
    for (const FlatFace& face : solid.faces) {
        // The plane touches the furthest vertex, so that rounding never puts a vertex above a face.
        double offset = -std::numeric_limits<double>::infinity();
        for (const Vec3& position : solid.mesh.positions) {
            offset = std::max(offset, face.normal.dot(position));
        }
        planes_.push_back({face.normal, offset, height_error(solid, face)});
    }
}

int ConvexSolid::exact_side(std::size_t face, const Vec3& point) const {
    return side_of_face(solid_, solid_.faces[face], point);
}

bool ConvexSolid::contains(const Vec3& point) const {
    if (!solid_.box.contains(point)) return false;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        const double above = planes_[k].height(point);
        if (above < -planes_[k].rounding) continue;
        if (above > planes_[k].rounding || exact_side(k, point) >= 0) return false;
    }
    return true;
}

std::optional<double> ConvexSolid::exit_through_face(const Vec3& point, const Vec3& direction,
                                                     double clearance) const {
    double exit = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::Zero();
    for (const Plane& plane : planes_) {
        const double height = plane.height(point), approach = plane.normal.dot(direction);
        if (height > 0) return std::nullopt;
        if (approach <= 0 || clearance - height >= exit * approach) continue;
        exit = (clearance - height) / approach;
        normal = plane.normal;
    }
    // The point reached is at the clearance from the solid exactly where its foot lies on the face.
    const Vec3 foot = point + exit * direction - clearance * normal;
    const auto is_above = [&](const Plane& plane) { return plane.height(foot) > solid_.rounding / 10; };
    if (std::ranges::any_of(planes_, is_above)) return std::nullopt;
    return exit;
}

NearestFace ConvexSolid::nearest_face(const Vec3& point) const {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes_) highest = std::max(highest, plane.height(point));
    const auto nearest = std::ranges::find_if(
        planes_, [&](const Plane& plane) { return plane.height(point) >= highest - solid_.rounding; });
    return {.face = static_cast<Index>(nearest - planes_.begin()),
            .normal = nearest->normal,
            .signed_distance = nearest->height(point)};
}

bool ConvexSolid::crossed_by(const Corners& organ_facet) const {
    const auto& [a, b, c] = organ_facet;
    bool crosses = false;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        const Plane& plane = planes_[k];
        const auto [lowest, highest] = std::minmax({plane.height(a), plane.height(b), plane.height(c)});
        if (lowest > plane.rounding) return false;  // the whole facet is above a face of a convex solid
        if (crosses || highest < -plane.rounding) continue;
        crosses = std::ranges::any_of(solid_.faces[k].facets, [&](Index f) {
            return facets_cross(organ_facet, solid_.corners(f), solid_.flat_edges[f]);
        });
    }
    return crosses;
}

}  // namespace trocar
