#include "common/geometry/solid.h"

#include <algorithm>

#include "common/geometry/general_solid.h"

namespace trocar {

struct Solid::Parts {
    explicit Parts(const SurfaceMesh& mesh) : solid(mesh), general(solid) {
        if (is_convex(solid)) {
            planes = std::make_unique<const ConvexSolid>(solid);
        } else {
            general.check_not_self_intersecting();
        }
    }

    SolidMesh solid;
    GeneralSolid general;
    std::unique_ptr<const ConvexSolid> planes;  // of a convex one
};

Solid::Solid(const SurfaceMesh& mesh) : parts_(std::make_shared<const Parts>(mesh)) {}

bool Solid::convex() const { return parts_->planes != nullptr; }

const Box& Solid::box() const { return parts_->solid.box; }

std::size_t Solid::face_count() const { return parts_->solid.faces.size(); }

bool Solid::contains(const Vec3& point) const {
    return convex() ? parts_->planes->contains(point) : parts_->general.contains(point);
}

double Solid::exit_distance(const Vec3& point, const Vec3& direction, double clearance) const {
    if (convex()) {
        const auto exit = parts_->planes->exit_through_face(point, direction, clearance);
        if (exit) return *exit;
    }
    return parts_->general.exit_distance(point, direction, clearance);
}

NearestFace Solid::nearest_face(const Vec3& point) const {
    if (convex()) return parts_->planes->nearest_face(point);
    const SurfacePoint nearest = closest(point);
    const double distance = (nearest.position - point).norm();
    return {.face = parts_->solid.face_of[nearest.facet],
            .normal = nearest.normal,
            .signed_distance = contains(point) ? -distance : distance};
}

SurfacePoint Solid::closest(const Vec3& point) const { return parts_->general.closest(point); }

bool Solid::within(const Vec3& point, double distance) const {
    if (!box().grown(distance).contains(point)) return false;
    if (convex()) {
        // A face's plane is never further away than the solid behind it.
        const double above = parts_->planes->nearest_face(point).signed_distance;
        if (above <= 0 || above > distance) return above <= 0;
    }
    return (closest(point).position - point).norm() <= distance || contains(point);
}

Vec3 Solid::support(const Vec3& direction) const {
    const std::vector<Vec3>& all = parts_->solid.mesh.positions;
    const Vec3* furthest = &all.front();
    double along = furthest->dot(direction);
    for (const Vec3& position : all) {
        const double other = position.dot(direction);
        if (!(other > along)) continue;
        furthest = &position;
        along = other;
    }
    return *furthest;
}

bool Solid::crossed_by(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return convex() ? parts_->planes->crossed_by({a, b, c}) : parts_->general.crossed_by({a, b, c});
}

}  // namespace trocar
