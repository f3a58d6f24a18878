#pragma once

#include "strategies/registry.h"

namespace trocar {

/// How nearest-face moves one collided vertex (mm). Convex tools: along the outer normal of the face whose
/// plane is nearest, to a clearance outside it. Others: towards the closest point of the surface, to the
/// exit; from the surface itself along the normal there. Other strategies fall back to it where they have no
/// direction.
Vec3 nearest_face_displacement(const Contact& contact, Index vertex);

/// The strategy `nearest-face`: [30] of the paper as its section V tells it (Fig. 5).
StrategyEntry nearest_face_entry();

}  // namespace trocar
