#pragma once

#include "experiments/scenes/scene.h"

namespace trocar {

/// The scene `penetration`: the tool's axis along the normal, from 3 mm clear along −n to 12 mm deep, hold
/// 0.5 s, back the same way, rest 1 s.
SceneEntry penetration_entry();

}  // namespace trocar
