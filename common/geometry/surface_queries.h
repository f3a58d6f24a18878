#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// A point of a surface.
struct SurfacePoint {
    Vec3 position;
    Index facet;
    Vec3 normal;  ///< outer unit normal of that facet
};

/// Searches of one surface that does not move, by CGAL's tree; prepared once.
/// Safe to ask from several threads.
class SurfaceQueries {
  public:
    /// The mesh must outlive it.
    explicit SurfaceQueries(const SurfaceMesh& mesh);
    ~SurfaceQueries();
    SurfaceQueries(const SurfaceQueries&) = delete;
    SurfaceQueries& operator=(const SurfaceQueries&) = delete;

    /// How far (mm) the ray from `origin` along the unit vector `direction` goes until it leaves through the
    /// surface (a facet whose outer normal points along the ray), further than `skip` mm away. None when it
    /// never does.
    [[nodiscard]] std::optional<double> distance_to_exit(const Vec3& origin, const Vec3& direction,
                                                         double skip) const;

    /// Strictly inside; the mesh must be closed.
    [[nodiscard]] bool contains(const Vec3& point) const;

    /// Distance to the surface, mm.
    [[nodiscard]] double distance(const Vec3& point) const;

    /// The closest point of the surface; of facets whose distances differ by `rounding` (mm) or less from the
    /// least that of the lowest number.
    [[nodiscard]] SurfacePoint closest(const Vec3& point, double rounding) const;

    /// The facets whose bounding box meets `box`, in no particular order.
    [[nodiscard]] std::vector<Index> facets_near(const Box& box) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

/// Two facets that meet without being neighbours, or neighbours that meet elsewhere than they join; none of a
/// sound surface.
std::optional<std::array<Index, 2>> self_intersection(const SurfaceMesh& mesh);

}  // namespace trocar
