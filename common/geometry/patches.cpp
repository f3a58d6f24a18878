#include "common/geometry/patches.h"

#include <algorithm>
#include <numeric>

namespace trocar {
namespace {

/// Splits `facets` in place; pieces are appended in the order in which they lie in it.
void split(std::span<Index> facets, std::span<const Vec3> centroids, std::size_t largest,
           std::vector<Patch>& patches) {
    if (facets.size() <= largest) {
        patches.push_back({.facets = {facets.begin(), facets.end()}, .vertices = {}});
        std::ranges::sort(patches.back().facets);
        return;
    }
    Box box;
    for (const Index facet : facets) box.add(centroids[facet]);
    int axis = 0;
    box.size().maxCoeff(&axis);
    const auto middle = facets.begin() + static_cast<std::ptrdiff_t>(facets.size() / 2);
    std::ranges::nth_element(facets, middle, [&](Index a, Index b) {
        const double at_a = centroids[a][axis], at_b = centroids[b][axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    split({facets.begin(), middle}, centroids, largest, patches);
    split({middle, facets.end()}, centroids, largest, patches);
}

}  // namespace

std::vector<Patch> split_into_patches(const SurfaceMesh& mesh, std::size_t largest) {
    const std::vector<Facet>& all = mesh.facets;
    std::vector<Vec3> centroids;
    centroids.reserve(all.size());
    for (const Facet& facet : all) {
        const auto& p = mesh.positions;
        centroids.emplace_back((p[facet[0]] + p[facet[1]] + p[facet[2]]) / 3);
    }
    std::vector<Index> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Patch> patches;
    split(order, centroids, largest, patches);

    std::vector<bool> taken(mesh.positions.size(), false);
    for (Patch& patch : patches) {
        for (const Index facet : patch.facets) {
            for (const Index vertex : all[facet]) {
                if (!taken[vertex]) patch.vertices.push_back(vertex);
                taken[vertex] = true;
            }
        }
        std::ranges::sort(patch.vertices);
    }
    return patches;
}

std::vector<Index> patch_of_vertices(std::span<const Patch> patches, std::size_t vertices) {
    std::vector<Index> patch_of(vertices, -1);
    for (std::size_t k = 0; k < patches.size(); ++k) {
        for (const Index vertex : patches[k].vertices) patch_of[vertex] = static_cast<Index>(k);
    }
    return patch_of;
}

}  // namespace trocar
