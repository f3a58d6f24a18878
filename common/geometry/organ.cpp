#include "common/geometry/organ.h"

#include <utility>

namespace trocar {

Organ make_organ(std::string name, SurfaceMesh rest) {
    Adjacency adjacency(rest.positions.size(), rest.facets);
    std::vector<Vec3> normals;
    normals.reserve(rest.facets.size());
    for (const Facet& facet : rest.facets) normals.push_back(facet_normal(rest.positions, facet));
    std::vector<double> areas = facet_areas(rest);
    std::vector<Patch> patches = split_into_patches(rest, largest_patch);
    return {.name = std::move(name),
            .rest = std::move(rest),
            .adjacency = std::move(adjacency),
            .rest_normals = std::move(normals),
            .rest_areas = std::move(areas),
            .patches = std::move(patches),
            .mouth = {},
            .outline = {}};
}

}  // namespace trocar
