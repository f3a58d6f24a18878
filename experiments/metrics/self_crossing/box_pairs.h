#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/geometry/vector.h"

namespace trocar {

/// The numbers (i, j) of all pairs of a box `one[i]` and a box `other[j]` that overlap or touch, in no
/// particular order.
std::vector<std::array<Index, 2>> box_pairs(std::span<const Box> one, std::span<const Box> other);

}  // namespace trocar
