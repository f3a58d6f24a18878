#pragma once

#include "common/geometry/facet_tree.h"
#include "common/geometry/solid_mesh.h"
#include "common/geometry/surface_queries.h"

namespace trocar {

/// Queries on any solid, by a search of its surface. None asks for memory.
class GeneralSolid {
  public:
    /// `solid` must outlive it.
    explicit GeneralSolid(const SolidMesh& solid);

    /// See Solid for the queries.
    [[nodiscard]] bool contains(const Vec3& point) const;
    [[nodiscard]] double exit_distance(const Vec3& point, const Vec3& direction, double clearance) const;
    [[nodiscard]] SurfacePoint closest(const Vec3& point) const;
    [[nodiscard]] bool crossed_by(const Corners& organ_facet) const;

    /// Throws std::invalid_argument, naming two facets, when parts of the surface meet that are no
    /// neighbours.
    void check_not_self_intersecting() const;

  private:
    const SolidMesh& solid_;
    FacetTree tree_;
};

}  // namespace trocar
