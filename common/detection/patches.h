#pragma once

#include <span>
#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

/// A piece of an organ's surface: facets that lie together at rest, and vertices. Every facet is in one
/// patch; every vertex too, in the first patch that has a facet of it.
struct Patch {
    std::vector<Index> facets;    ///< ascending
    std::vector<Index> vertices;  ///< ascending
};

/// Splits an organ at the middle of its longest side, again and again, until no piece has more than `largest`
/// facets.
std::vector<Patch> split_into_patches(const Organ& organ, std::size_t largest);

}  // namespace trocar
