#pragma once

#include "experiments/scenes/scene.h"

/// One function per scene.
namespace trocar::scenes {

/// @{
/// Each is defined in the file of its name.
SceneEntry penetration();
SceneEntry thin();
SceneEntry extraction();
SceneEntry sliding();
SceneEntry oblique();
SceneEntry cutting();
SceneEntry pivot();
SceneEntry twisting();
SceneEntry breathing();
SceneEntry recorded();
/// @}

}  // namespace trocar::scenes
