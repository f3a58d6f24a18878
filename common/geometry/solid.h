#pragma once

#include <array>
#include <vector>

#include "common/geometry/adjacency.h"
#include "common/geometry/predicates.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Answer to "what of the surface is nearest?".
struct NearestFace {
    Index face;              ///< number of the flat face, in the order of their lowest facets
    Vec3 normal;             ///< its outer unit normal
    double signed_distance;  ///< of the asked point to the face's plane, mm: negative below it
};

/// The inside of a closed, convex triangle mesh, prepared once for queries in the mesh's own frame. Facets
/// that lie in one plane count as one flat face.
class Solid {
  public:
    /// Throws std::invalid_argument when the mesh is not closed, not convex or has its normals inwards.
    explicit Solid(const SurfaceMesh& mesh);

    /// Whether `point` lies strictly inside, decided exactly for these very coordinates.
    [[nodiscard]] bool contains(const Vec3& point) const;

    /// e(x, d) of the method: how far a point that is inside goes along the unit vector `direction` until it
    /// is outside at a distance of at least `clearance` (mm). It meets the faces moved out by the clearance,
    /// which at an edge may be a little further than needed. Infinite when no face lies ahead.
    [[nodiscard]] double exit_distance(const Vec3& point, const Vec3& direction, double clearance) const;

    /// The face whose plane is nearest to a point inside; of equally near ones the lowest number. For a point
    /// outside it is the face whose plane the point is furthest above.
    [[nodiscard]] NearestFace nearest_face(const Vec3& point) const;

    /// Closest point of the surface.
    [[nodiscard]] Vec3 closest_point(const Vec3& point) const;

    /// Whether a point outside is within `distance` (mm) of the solid; true for a point inside.
    [[nodiscard]] bool within(const Vec3& point, double distance) const;

    /// The solid's vertex that is furthest along `direction`.
    [[nodiscard]] Vec3 support(const Vec3& direction) const;

    /// Whether the organ facet with these corners crosses the solid's surface, by exact signs; touching is
    /// not crossing (see facets_cross).
    [[nodiscard]] bool crossed_by(const Vec3& a, const Vec3& b, const Vec3& c) const;

    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] std::size_t face_count() const { return faces_.size(); }

  private:
    struct Face {
        Vec3 normal;                // outer unit normal
        double offset;              // normal · x on the face
        std::vector<Index> facets;  // of the mesh, all exactly in this plane
    };

    [[nodiscard]] double height(const Face& face, const Vec3& point) const {
        return face.normal.dot(point) - face.offset;
    }

    void gather_faces(const Adjacency& adjacency);
    void check_convex() const;
    [[nodiscard]] Corners corners(Index facet) const;
    [[nodiscard]] int exact_side(const Face& face, const Vec3& point) const;

    SurfaceMesh mesh_;
    std::vector<std::array<bool, 3>> flat_edges_;  // per facet: its neighbour over edge k lies in its plane
    std::vector<Face> faces_;
    Box box_;
    double rounding_ = 0;  // heights at most this far from zero (mm) may have the wrong sign
};

}  // namespace trocar
