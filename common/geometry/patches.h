#pragma once

#include <span>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// A piece of an organ's surface: facets that lie together at rest, and vertices. Every facet is in one
/// patch; every vertex too, in the first patch that has a facet of it. Detection refits an organ patch by
/// patch, and deformation lets patches sleep, so that a step costs what moves.
struct Patch {
    std::vector<Index> facets;    ///< ascending
    std::vector<Index> vertices;  ///< ascending
};

/// Facets of a patch at most. On an organ of 30,000, 64 to 192 cost the same; 32 cost more to keep track of,
/// and 256 keep more awake than the tool moves.
constexpr std::size_t largest_patch = 128;

/// Splits a surface at the middle of its longest side, again and again, until no piece has more than
/// `largest` facets.
std::vector<Patch> split_into_patches(const SurfaceMesh& mesh, std::size_t largest);

/// The number of the patch that has each vertex; −1 for a vertex in no facet.
std::vector<Index> patch_of_vertices(std::span<const Patch> patches, std::size_t vertices);

}  // namespace trocar
