#pragma once

#include "experiments/scenes/scene.h"

namespace trocar {

/// For each step whether the tool, at its pose, meets the organ at rest: a vertex or facet of the organ is
/// inside or across it, or it is swallowed whole. No strategy can change this set of steps, so figures are
/// taken over it.
std::vector<bool> window_of(const SceneInputs& inputs, const std::vector<Pose>& poses);

}  // namespace trocar
