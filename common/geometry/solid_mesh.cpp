#include "common/geometry/solid_mesh.h"

#include <stdexcept>
#include <utility>

#include "common/geometry/flat_edges.h"

namespace trocar {
namespace {

/// The facets that a flood over flat edges reaches from `seed`; `face_of` is theirs afterwards.
FlatFace flood(const SolidMesh& solid, const Adjacency& adjacency, Index seed, Index face,
               std::vector<Index>& face_of) {
    FlatFace found{.normal = Vec3::Zero(), .facets = {seed}};
    face_of[seed] = face;
    for (std::size_t next = 0; next < found.facets.size(); ++next) {  // the list grows as it is walked
        const Index facet = found.facets[next];
        found.normal += facet_area_vector(solid.mesh.positions, solid.mesh.facets[facet]);
        for (int k = 0; k < 3; ++k) {
            if (!solid.flat_edges[facet][k]) continue;
            const Index other = facet_beyond(solid.mesh, adjacency, facet, k);
            if (face_of[other] >= 0) continue;
            face_of[other] = face;
            found.facets.push_back(other);
        }
    }
    found.normal.normalize();
    return found;
}

}  // namespace

SolidMesh::SolidMesh(SurfaceMesh the_mesh) : mesh(std::move(the_mesh)), box(bounding_box(mesh.positions)) {
    const Adjacency adjacency(mesh.positions.size(), mesh.facets);
    if (mesh.facets.empty() || !adjacency.closed()) {
        throw std::invalid_argument("a solid needs a closed mesh; this one has a boundary");
    }
    if (!(signed_volume(mesh) > 0)) {
        throw std::invalid_argument(
            "a solid needs its facets counter-clockwise seen from outside; those of this mesh enclose no "
            "volume or are the other way round");
    }
    rounding = 1e-11 * box.size().norm();
    flat_edges = trocar::flat_edges(mesh, adjacency);
    face_of.assign(mesh.facets.size(), -1);
    for (Index seed = 0; seed < static_cast<Index>(mesh.facets.size()); ++seed) {
        if (face_of[seed] >= 0) continue;
        faces.push_back(flood(*this, adjacency, seed, static_cast<Index>(faces.size()), face_of));
    }
}

}  // namespace trocar
