#pragma once

#include <optional>
#include <vector>

#include "common/geometry/solid_mesh.h"

namespace trocar {

/// Answer to "which face is nearest?".
struct NearestFace {
    Index face;              ///< number of the flat face, in the order of their lowest facets
    Vec3 normal;             ///< its outer unit normal
    double signed_distance;  ///< of the asked point, mm: negative inside
};

/// Whether no vertex lies above any face, by exact signs.
bool is_convex(const SolidMesh& solid);

/// The planes around a convex solid: what they can answer, they answer faster than a search of the surface.
/// Exact where GeneralSolid is.
class ConvexSolid {
  public:
    /// `solid` must be convex and outlive it.
    explicit ConvexSolid(const SolidMesh& solid);

    /// Strictly inside.
    [[nodiscard]] bool contains(const Vec3& point) const;

    /// The exit distance (see Solid) where it leads through a face moved out by the clearance; none where an
    /// edge or a corner decides, or where the point is not inside.
    [[nodiscard]] std::optional<double> exit_through_face(const Vec3& point, const Vec3& direction,
                                                          double clearance) const;

    /// The face whose plane the point is least below or furthest above; of equal ones the lowest number.
    [[nodiscard]] NearestFace nearest_face(const Vec3& point) const;

    /// See Solid::crossed_by.
    [[nodiscard]] bool crossed_by(const Corners& organ_facet) const;

  private:
    struct Plane {
        Vec3 normal;
        double offset;    // normal · x on the plane
        double rounding;  // heights at most this far from zero (mm) may have the wrong sign

        [[nodiscard]] double height(const Vec3& point) const { return normal.dot(point) - offset; }
    };

    [[nodiscard]] int exact_side(std::size_t face, const Vec3& point) const;

    const SolidMesh& solid_;
    std::vector<Plane> planes_;  // one for each face
};

}  // namespace trocar
