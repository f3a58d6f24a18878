#pragma once

#include "experiments/scenes/scene.h"

namespace trocar::scenes {

/// From 3 mm clear straight along −`out` until the tip is `depth` (mm) beyond the entry point, hold 0.5 s,
/// back the same way, rest 1 s. The tool's axis is the placement's normal; `out` is a vector along which the
/// normal's part has length 1, so that clearance and depth are heights over the surface.
ScenePlan straight_in(const SceneInputs& inputs, const Placement& at, const Vec3& out, double depth);

/// How a tool that starts `depth` (mm) below the entry point came there: along −n, from 3 mm clear.
Insertion inserted(const Placement& at, double depth);

}  // namespace trocar::scenes
