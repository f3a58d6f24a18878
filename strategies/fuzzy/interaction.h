#pragma once

#include "common/geometry/vector.h"

namespace trocar::fuzzy {

/// ε of the paper's Fig. 2a: the |I_C| at which neighbouring interaction cases weigh the same (45°).
inline constexpr double threshold = 0.7071;

/// I = (I_P, I_S, I_E): how much a situation is like each of the paper's three interaction cases, in [0, 1].
/// They need not sum to one.
struct Weights {
    double penetration = 0, sliding = 0, extraction = 0;
};

/// Eq. (2): I_P v_m − I_S n − I_E v_m, for a motion and a normal of unit length; of length at most √2.
inline Vec3 displacement(const Weights& weights, const Vec3& motion, const Vec3& normal) {
    return weights.penetration * motion - weights.sliding * normal - weights.extraction * motion;
}

}  // namespace trocar::fuzzy
