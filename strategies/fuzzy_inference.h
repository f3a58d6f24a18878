#pragma once

namespace trocar::fuzzy {

/// ε of the paper's Fig. 2a: where neighbouring interaction cases weigh the same (45°).
inline constexpr double threshold = 0.7071;

/// One number for each of the paper's three interaction cases.
struct Cases {
    double penetration, sliding, extraction;
};

/// Memberships of the collision index I_C (eq. 1) in the three cases, each in [0, 1], together 1: piecewise
/// linear ramps of width 2 (1 − ε) around ∓ε.  (◇: the text gives the crossing points of Fig. 2a, not the
/// shape.)
Cases memberships(double collision_index);

/// I = (I_P, I_S, I_E) from the first facet of a vertex, C_1 = YES: rules 1 to 3 of Table I. The case that
/// I_C names gets HIGH, the others LOW.
Cases first_pass(double collision_index);

/// I from a further facet, C_1 = NO: rule 6 of Table I. Each weight is inferred from its value before and
/// from whether I_C names its case.
///
/// The table itself is lost; these rules are our reading (◇), see README.md of this folder. Inference is
/// zero-order Takagi–Sugeno: product conjunction, weighted average of the outputs LOW = 0, MEDIUM = ½, HIGH
/// = 1.
Cases feedback(double collision_index, const Cases& previous);

}  // namespace trocar::fuzzy
