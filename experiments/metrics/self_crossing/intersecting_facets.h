#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Two different facets, the lower number first.
using FacetPair = std::array<Index, 2>;

/// CGAL's Polygon_mesh_processing::self_intersections. Safe to ask from several threads.
class IntersectingFacets {
  public:
    /// @param mesh whose facets are asked about; it may be dropped. Throws std::invalid_argument when it is
    /// not
    ///   manifold or not consistently oriented.
    explicit IntersectingFacets(const SurfaceMesh& mesh);
    ~IntersectingFacets();
    IntersectingFacets(const IntersectingFacets&) = delete;
    IntersectingFacets& operator=(const IntersectingFacets&) = delete;

    /// The pairs among `facets` that meet, if only in a point, elsewhere than in the vertex or edge that they
    /// share, with vertices at `positions` (mm); ascending. Exact. CGAL names facets without area apart, as
    /// pairs of one facet, and never together with others: they are in no pair here.
    [[nodiscard]] std::vector<FacetPair> pairs(std::span<const Index> facets,
                                               std::span<const Vec3> positions) const;

  private:
    struct CgalMesh;
    std::unique_ptr<CgalMesh> mesh_;
};

}  // namespace trocar
