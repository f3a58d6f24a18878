#pragma once

#include <functional>
#include <numbers>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Rings of points, one above the other, that are joined to a closed mesh.
class Rings {
  public:
    explicit Rings(Index points_per_ring) : count_(points_per_ring) {}

    /// Adds a ring of the points at(angle), counter-clockwise seen from the side on which the next ring lies.
    template <class PointAt>
    void add(PointAt at) {
        for (Index i = 0; i < count_; ++i) points_.push_back(at(2 * std::numbers::pi * i / count_));
    }

    /// A sphere's topology: the first ring is closed by a point below it, the last by a point above it.
    [[nodiscard]] SurfaceMesh between_poles(const Vec3& below, const Vec3& above) const;

    /// A torus's topology: the last ring is joined to the first.
    [[nodiscard]] SurfaceMesh torus() const;

  private:
    void join(Index lower, Index upper, SurfaceMesh& mesh) const;

    Index count_;
    std::vector<Vec3> points_;
};

}  // namespace trocar
