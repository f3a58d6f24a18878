#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

/// The star of each vertex of an organ: the facets around it.
class VertexStars {
  public:
    explicit VertexStars(const Organ& organ);

    /// A direction (of some length) along which the star is seen unfolded: every facet from its outer side,
    /// and no two over each other. Then its facets meet only where they join. It is the mean of the facets'
    /// normals by their areas; none where that direction does not show it, clear of rounding.
    [[nodiscard]] std::optional<Vec3> unfolding(Index vertex, std::span<const Vec3> positions) const;

    /// As long as no vertex of the star is this far (mm) from where it is in `positions`, the star is seen
    /// unfolded along the same direction: half the least height of its facets as they are seen along it. For
    /// three points come to lie on one line at the earliest when one of them has moved by half that height,
    /// and on the way there nothing else can end the unfolding. 0 where it is not unfolded.
    [[nodiscard]] double freedom(Index vertex, std::span<const Vec3> positions) const;

  private:
    struct Star {
        Index first;  // of its entries of ends_
        Index count;
        bool closed;  // its last spoke and its first one have a facet between them
    };
    void add_star(const Organ& organ, Index vertex);
    [[nodiscard]] std::vector<Vec3> spokes(Index vertex, std::span<const Vec3> positions) const;

    std::vector<Star> stars_;
    std::vector<Index> ends_;  // the other ends of each vertex's edges, counter-clockwise
};

}  // namespace trocar
