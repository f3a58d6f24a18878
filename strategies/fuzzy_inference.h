#pragma once

#include "common/geometry/vector.h"

namespace trocar::fuzzy {

/// ε of the paper's Fig. 2a: where neighbouring interaction cases weigh the same (45°).
inline constexpr double threshold = 0.7071;

/// One number for each of the paper's three interaction cases.
struct Cases {
    double penetration, sliding, extraction;
};

/// How the memberships of I_C pass from one case to the next (◇: the text gives the crossing points of
/// Fig. 2a, not the shape).
enum class Shape {
    ramp,    ///< linear, over a width of 2 (1 − ε) around ∓ε
    smooth,  ///< over the same width, along the cubic t² (3 − 2t)
    crisp,   ///< all at once at ∓ε
};

/// Memberships of the collision index I_C (eq. 1) in the three cases, each in [0, 1], together 1.
Cases memberships(double collision_index, Shape shape = Shape::ramp);

/// I = (I_P, I_S, I_E) from the first facet of a vertex, C_1 = YES: rules 1 to 3 of Table I. The case that
/// I_C names gets HIGH, the others LOW.
Cases first_pass(double collision_index, Shape shape = Shape::ramp);

/// I from a further facet, C_1 = NO: rule 6 of Table I. Each weight is inferred from its value before and
/// from whether I_C names its case.
///
/// The table itself is lost; these rules are our reading (◇), see fuzzy_per_vertex.md. Inference is
/// zero-order Takagi–Sugeno: product conjunction, weighted average of the outputs LOW = 0, MEDIUM = ½, HIGH
/// = 1.
Cases feedback(double collision_index, const Cases& previous, Shape shape = Shape::ramp);

/// Eq. (2): I_P v_m − I_S n − I_E v_m, for a motion and a normal of unit length; of length at most √2.
Vec3 displacement(const Cases& weights, const Vec3& motion, const Vec3& normal);

}  // namespace trocar::fuzzy
