#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// CGAL's Side_of_triangle_mesh, exact predicates, its tree built beforehand.
class CgalPeer {
  public:
    explicit CgalPeer(const SurfaceMesh& mesh);
    ~CgalPeer();
    CgalPeer(const CgalPeer&) = delete;
    CgalPeer& operator=(const CgalPeer&) = delete;

    /// Whether the point is strictly inside.
    [[nodiscard]] bool contains(const Vec3& point) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace trocar
