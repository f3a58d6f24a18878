#include "common/geometry/flat_edges.h"

#include <algorithm>

#include "common/geometry/predicates.h"

namespace trocar {
namespace {

bool has_corner(const Facet& facet, Index vertex) { return std::ranges::find(facet, vertex) != facet.end(); }

/// Whether all corners of `other` lie exactly in the plane of `facet`.
bool coplanar(const SurfaceMesh& mesh, const Facet& facet, const Facet& other) {
    const auto& p = mesh.positions;
    return std::ranges::all_of(other, [&](Index corner) {
        return orientation_sign(p[facet[0]], p[facet[1]], p[facet[2]], p[corner]) == 0;
    });
}

}  // namespace

Index facet_beyond(const SurfaceMesh& mesh, const Adjacency& adjacency, Index facet, int k) {
    const Index a = mesh.facets[facet][k], b = mesh.facets[facet][(k + 1) % 3];
    const auto ring = adjacency.ring(a);
    const auto found = std::ranges::find_if(
        ring, [&](Index other) { return other != facet && has_corner(mesh.facets[other], b); });
    return found == ring.end() ? -1 : *found;
}

std::vector<std::array<bool, 3>> flat_edges(const SurfaceMesh& mesh, const Adjacency& adjacency) {
    std::vector<std::array<bool, 3>> flat(mesh.facets.size());
    for (Index facet = 0; facet < static_cast<Index>(mesh.facets.size()); ++facet) {
        for (int k = 0; k < 3; ++k) {
            const Index other = facet_beyond(mesh, adjacency, facet, k);
            flat[facet][k] = other >= 0 && coplanar(mesh, mesh.facets[facet], mesh.facets[other]);
        }
    }
    return flat;
}

}  // namespace trocar
