#pragma once

#include <span>
#include <vector>

#include "common/geometry/vector.h"

namespace trocar {

/// A facet's side as one of the uses of an edge. Unlike Adjacency this serves broken meshes as well.
struct EdgeUse {
    Index low, high;  ///< the edge's vertices
    Index facet;
    bool forward;  ///< the facet runs from low to high
};

/// Every side of every facet, ascending by edge, then by facet: an edge's uses stand together.
std::vector<EdgeUse> edge_uses(std::span<const Facet> facets);

/// Calls visit(std::span<const EdgeUse>) with the uses of one edge after the other.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit visit) {
    while (!uses.empty()) {
        std::size_t count = 1;
        while (count < uses.size() && uses[count].low == uses[0].low && uses[count].high == uses[0].high)
            ++count;
        visit(uses.first(count));
        uses = uses.subspan(count);
    }
}

/// Numbers that are joined into sets, step by step.
class DisjointSets {
  public:
    /// Each of the numbers below `count` is a set of its own.
    explicit DisjointSets(std::size_t count);

    /// The lowest number of the set.
    Index find(Index element);
    void unite(Index a, Index b);

  private:
    std::vector<Index> parent_;
};

}  // namespace trocar
