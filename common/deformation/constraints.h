#pragma once

#include "common/geometry/vector.h"

namespace trocar {

/// A force on a vertex during one step, in g·mm/s² (= µN).
struct VertexForce {
    Index vertex;
    Vec3 force;
};

/// The deformation keeps `vertex` where normal · x ≥ normal · point during one step.
struct HalfSpace {
    Index vertex;
    Vec3 point;   ///< any point of the plane, mm
    Vec3 normal;  ///< unit, towards the side that is allowed
};

}  // namespace trocar
