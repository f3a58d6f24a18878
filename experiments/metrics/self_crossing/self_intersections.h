#pragma once

#include <span>
#include <vector>

#include "common/geometry/organ.h"
#include "common/geometry/predicates.h"
#include "experiments/metrics/self_crossing/intersecting_facets.h"
#include "experiments/metrics/self_crossing/vertex_stars.h"

namespace trocar {

/// Which of an organ's facets intersect, as CGAL tells of the whole mesh (see IntersectingFacets). It is only
/// asked about facets of which nothing simpler shows that they do not:
///
/// Of every facet it is known how far its vertices may move from rest before it meets one that it does not
/// meet at rest, if that one keeps to its own limit. Only facets beyond that limit are looked at: with those
/// that share a vertex with them, whether the vertex's star unfolds; with others, whether a slab of space
/// lies between them.
/// Safe to ask from several threads.
class SelfIntersections {
  public:
    /// Searches the organ at rest. It must outlive this.
    explicit SelfIntersections(const Organ& organ);

    /// The pairs at rest, ascending.
    [[nodiscard]] const std::vector<FacetPair>& at_rest() const { return at_rest_; }

    /// The pairs of an organ with these vertices (mm) that are no pairs at rest, ascending.
    [[nodiscard]] std::vector<FacetPair> beyond_rest(std::span<const Vec3> positions) const;

    /// The facets that CGAL is asked about there, ascending.
    [[nodiscard]] std::vector<Index> doubtful(std::span<const Vec3> positions) const;

  private:
    [[nodiscard]] Corners corners(std::span<const Vec3> positions, Index facet) const;
    [[nodiscard]] bool at_rest(Index one, Index other) const;
    [[nodiscard]] std::vector<Index> moved(std::span<const Vec3> positions) const;
    void find_freedom();

    const Organ& organ_;
    IntersectingFacets cgal_;
    VertexStars stars_;
    std::vector<FacetPair> at_rest_;
    std::vector<double> freedom_;  // of each facet: the limit, mm
};

}  // namespace trocar
