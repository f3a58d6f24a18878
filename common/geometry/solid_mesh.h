#pragma once

#include <array>
#include <vector>

#include "common/geometry/predicates.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Facets that are joined by edges and lie exactly in one plane.
struct FlatFace {
    Vec3 normal;                ///< outer unit normal
    std::vector<Index> facets;  ///< the first is the lowest
};

/// A closed mesh with its facets outwards, and what every kind of query on its inside needs to know of it.
struct SolidMesh {
    /// Throws std::invalid_argument when the mesh has a boundary, is not manifold or points inwards.
    explicit SolidMesh(SurfaceMesh the_mesh);

    [[nodiscard]] Corners corners(Index facet) const {
        const Facet& f = mesh.facets[facet];
        return {mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]};
    }

    SurfaceMesh mesh;
    std::vector<std::array<bool, 3>> flat_edges;  ///< see flat_edges()
    std::vector<FlatFace> faces;                  ///< in the order of their lowest facets
    std::vector<Index> face_of;                   ///< of each facet
    Box box;
    /// Distances (mm) that differ by no more than this count as equal: rounding of a point's coordinates must
    /// not decide which of two equally near facets is the nearest.
    double rounding = 0;
};

}  // namespace trocar
