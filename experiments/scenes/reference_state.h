#pragma once

#include "common/cycle/cycle.h"
#include "experiments/scenes/scene.h"

namespace trocar {

/// The organ at equilibrium around a tool that is inside it when the scene starts. The tool comes straight
/// in, in steps of at most 0.5 mm; vertices that are inside it go along its way to the exit and stay, the
/// rest relaxes. It depends on no strategy and on no speed. Throws std::runtime_error when the organ does not
/// come to rest.
/// @param start where the tool is when the scene starts
/// @param clearance g, mm
CycleStart reference_state(const SceneInputs& inputs, const Pose& start, const Insertion& insertion,
                           double clearance, const SpringSettings& springs);

}  // namespace trocar
