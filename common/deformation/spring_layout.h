#pragma once

#include <cstdint>
#include <vector>

#include "common/deformation/spring_network.h"
#include "common/geometry/number_lists.h"

namespace trocar {

/// How a spring network lies in memory. A vertex is a slot: slots run patch by patch, and springs too, so
/// that what is awake lies together. Springs are done level by level: a spring is one level above the highest
/// spring before it, in the network's order, that shares a vertex with it. No two springs of a level share a
/// vertex, so that the processor need not wait for one to do the next; yet each spring finds its vertices
/// exactly as it would in the network's order, to the bit.
struct SpringLayout {
    /// Between two slots.
    struct Spring {
        std::uint32_t a, b, level;
        double rest_length;  ///< mm
        double compliance;   ///< over the square of the substep, 1/g
    };

    std::vector<Index> vertex_of;             ///< each slot's vertex
    std::vector<std::uint32_t> slot_of;       ///< each vertex's slot
    std::vector<std::uint32_t> patch_of;      ///< each slot's patch
    std::vector<std::uint32_t> patch_begins;  ///< each patch's first slot; one more at the end
    std::vector<Spring> springs;              ///< by the patch of a, within it by level
    NumberLists springs_at;                   ///< for each patch the springs with an end in it, ascending
    NumberLists neighbours;  ///< for each patch the others that a spring joins it to, ascending
    NumberLists outer;       ///< for each patch the slots of others that a spring joins it to, ascending

    [[nodiscard]] std::size_t patches() const { return patch_begins.size() - 1; }
};

/// Lays out a network. @param substep s
SpringLayout lay_out(const SpringNetwork& network, double substep);

}  // namespace trocar
