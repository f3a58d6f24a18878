#pragma once

#include <memory>

#include "common/geometry/convex_solid.h"
#include "common/geometry/surface_queries.h"

namespace trocar {

/// The inside of a closed triangle mesh, prepared once for queries in the mesh's own frame, convex or not.
/// Copies share what is prepared; safe to ask from several threads.
class Solid {
  public:
    /// Throws std::invalid_argument when the mesh has a boundary, is not manifold, points inwards or meets
    /// itself.
    explicit Solid(const SurfaceMesh& mesh);

    /// Whether it is convex, decided exactly; a flat face may have any number of facets.
    [[nodiscard]] bool convex() const;

    /// Whether `point` lies strictly inside, decided exactly for these very coordinates.
    [[nodiscard]] bool contains(const Vec3& point) const;

    /// e(x, d) of the method: the smallest t >= 0 at which point + t direction lies outside at a distance of
    /// at least `clearance` from the surface. The first such place: a point in one jaw of a tool is not sent
    /// through the other.
    /// @param direction of unit length
    /// @param clearance mm, above zero
    [[nodiscard]] double exit_distance(const Vec3& point, const Vec3& direction, double clearance) const;

    /// Convex: the face whose plane is nearest to a point inside, and the one whose plane a point outside is
    /// furthest above; the distance is to that plane. Otherwise: the face that carries the closest point of
    /// the surface; the distance is to that point. Of faces equally near within rounding the lowest number.
    [[nodiscard]] NearestFace nearest_face(const Vec3& point) const;

    /// The closest point of the surface; of facets equally near within rounding that of the lowest number.
    [[nodiscard]] SurfacePoint closest(const Vec3& point) const;

    /// Whether a point outside is within `distance` (mm) of the solid; true for a point inside.
    [[nodiscard]] bool within(const Vec3& point, double distance) const;

    /// The solid's vertex that is furthest along `direction`.
    [[nodiscard]] Vec3 support(const Vec3& direction) const;

    /// Whether the organ facet with these corners crosses the solid's surface, by exact signs; touching is
    /// not crossing (see facets_cross).
    [[nodiscard]] bool crossed_by(const Vec3& a, const Vec3& b, const Vec3& c) const;

    [[nodiscard]] const Box& box() const;
    [[nodiscard]] std::size_t face_count() const;

  private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

}  // namespace trocar
