#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "experiments/turns/single_vertex.h"

namespace trocar::turns {

/// Between neighbouring motions of a walk, degrees.
inline constexpr double step = 0.25;
/// So many steps of a walk are one degree.
inline constexpr std::size_t steps_a_degree = 4;
static_assert(step * steps_a_degree == 1);
/// Of a walk, each along a great circle to the opposite direction, 30° beside the one before: no direction is
/// further than 15° from all of them, so that whatever a strategy decides by an angle, it has to decide.
inline constexpr std::size_t half_turns = 12;
/// The length of a walk, degrees.
inline constexpr double walk_length = 180.0 * half_turns;

/// v_m step by step: unit vectors, the last of them the first again. Motions k steps apart are at most k
/// `step` degrees apart, at the ends of half turns too.
std::vector<Vec3> walk_of_motions(const SingleVertex& vertex);

/// How far the vertex is moved along its line at once, mm.
inline constexpr double shift = 0.01;

/// Two places of a patch, one shift apart: at one the tool face nearest to the vertex is another than at the
/// other one.
struct Switch {
    std::array<std::vector<Vec3>, 2> positions;  ///< of the patch's vertices, mm
};

/// All of them along the vertex's line through the tool, at least one: a line leaves a convex tool through
/// another face than it came in by.
std::vector<Switch> find_switches(const SingleVertex& vertex);

}  // namespace trocar::turns
