#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/geometry/vector.h"

namespace trocar {

/// An edge's two vertices, the lower index first.
using Edge = std::array<Index, 2>;

/// Which facets and vertices lie around each vertex of a manifold, consistently oriented triangle surface,
/// stored compactly (one array of entries, one of offsets).
class Adjacency {
  public:
    /// Throws std::invalid_argument when a facet names a vertex outside [0, vertex_count), or when the
    /// facets around a vertex do not form one fan (the surface is not manifold there).
    Adjacency(std::size_t vertex_count, std::span<const Facet> facets);

    /// N(i) of the paper: the facets around `vertex`, counter-clockwise seen from outside, starting with the
    /// one of lowest index, until begin_ring_at says otherwise. At a boundary vertex the fan is open: the
    /// facet after its last one is its first.
    [[nodiscard]] std::span<const Index> ring(Index vertex) const {
        return entries(ring_facets_, ring_offsets_, vertex);
    }
    /// Turns the ring of `vertex` so that it begins at `facet`, an open fan likewise. The surface is the
    /// same: this is for asking how much an answer depends on where rings begin. Throws std::invalid_argument
    /// when `facet` is not in the ring.
    void begin_ring_at(Index vertex, Index facet);
    /// The vertices that share an edge with `vertex`, by ascending index.
    [[nodiscard]] std::span<const Index> neighbours(Index vertex) const {
        return entries(neighbours_, neighbour_offsets_, vertex);
    }
    /// Every edge once, in ascending order.
    [[nodiscard]] std::span<const Edge> edges() const { return edges_; }

    [[nodiscard]] bool on_boundary(Index vertex) const { return on_boundary_[vertex]; }

    /// No edge has a facet on one side only.
    [[nodiscard]] bool closed() const { return closed_; }

  private:
    static std::span<const Index> entries(const std::vector<Index>& all, const std::vector<Index>& offsets,
                                          Index vertex) {
        return {all.data() + offsets[vertex], all.data() + offsets[vertex + 1]};
    }

    std::vector<Index> ring_facets_, ring_offsets_;
    std::vector<Index> neighbours_, neighbour_offsets_;
    std::vector<Edge> edges_;
    std::vector<bool> on_boundary_;
    bool closed_ = true;
};

}  // namespace trocar
