#pragma once

#include "experiments/scenes/scene.h"

namespace trocar {

/// Where the seed puts the tool: an entry point drawn uniformly by area, at least two tool radii from the
/// boundary of an open organ. Points whose inward ray leaves the organ nearer than twice `depth` (mm) are not
/// drawn. Throws PlacementError when no such point is found.
Placement place(const SceneInputs& inputs, double depth);

/// The pose of a tool whose axis points along the placement's normal, tip at `tip`.
Pose upright_pose(const Placement& placement, const Vec3& tip);

}  // namespace trocar
