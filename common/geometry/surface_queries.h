#pragma once

#include <memory>
#include <optional>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Rays and inside-tests against one surface that does not move, by CGAL's tree; prepared once.
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

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace trocar
