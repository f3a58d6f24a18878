#include "common/geometry/mesh_topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace trocar {

std::vector<EdgeUse> edge_uses(std::span<const Facet> facets) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * facets.size());
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto [a, b, c] = facets[f];
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            uses.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(f), from < to});
        }
    }
    std::ranges::sort(uses, {}, [](const EdgeUse& use) { return std::tuple(use.low, use.high, use.facet); });
    return uses;
}

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
}

Index DisjointSets::find(Index element) {
    while (parent_[element] != element) {
        parent_[element] = parent_[parent_[element]];
        element = parent_[element];
    }
    return element;
}

void DisjointSets::unite(Index a, Index b) {
    const Index root_a = find(a), root_b = find(b);
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace trocar
