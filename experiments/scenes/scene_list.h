#pragma once

#include "experiments/scenes/scene.h"

/// One function per scene, each in a file of its own name.
namespace trocar::scenes {

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

}  // namespace trocar::scenes
