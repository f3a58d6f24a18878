#pragma once

#include <array>
#include <vector>

#include "common/geometry/adjacency.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// For every facet and each of its edges (edge k runs from corner k to corner k + 1): whether the facet on
/// the other side lies in exactly the same plane, so that the edge is none of the surface's shape.
std::vector<std::array<bool, 3>> flat_edges(const SurfaceMesh& mesh, const Adjacency& adjacency);

/// The facet on the other side of edge k of `facet`; −1 at a boundary.
Index facet_beyond(const SurfaceMesh& mesh, const Adjacency& adjacency, Index facet, int k);

}  // namespace trocar
