#pragma once

#include <array>
#include <cstdint>

namespace trocar {

/// Four numbers drawn uniformly from [0, 1), the same for the same arguments on every machine: a
/// counter-based generator (Philox4x64-10, Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
/// 2011).
/// @param seed of the case: one stream each
/// @param counter which draw of the stream
std::array<double, 4> draw(std::uint64_t seed, std::uint64_t counter);

}  // namespace trocar
