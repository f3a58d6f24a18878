#include "strategies/fuzzy_inference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trocar::fuzzy {
namespace {

// The terms of I_P, I_S, I_E (Fig. 2b), as outputs: the peaks of a partition of [0, 1] into triangles.
constexpr double low = 0, medium = 0.5, high = 1;

/// Membership of a weight in LOW, MEDIUM, HIGH; together 1.
std::array<double, 3> term_memberships(double weight) {
    return {std::max(0.0, 1 - 2 * weight), 1 - std::abs(2 * weight - 1), std::max(0.0, 2 * weight - 1)};
}

/// Rule 6: the weight inferred from the term it had before (row) and from the evidence (column: HIGH where
/// I_C names its case, LOW where it does not).
struct FeedbackRule {
    double evidence_high, evidence_low;
};
constexpr std::array<FeedbackRule, 3> feedback_rules = {{
    {medium, low},   // previous LOW
    {high, low},     // previous MEDIUM
    {high, medium},  // previous HIGH
}};

double infer(double previous, double evidence) {
    const std::array<double, 3> terms = term_memberships(previous);
    double weight = 0;
    for (std::size_t term = 0; term < terms.size(); ++term) {
        weight += terms[term] * evidence * feedback_rules[term].evidence_high;
        weight += terms[term] * (1 - evidence) * feedback_rules[term].evidence_low;
    }
    return weight;  // the rules' strengths sum to one, so this is their weighted average
}

/// Membership of ±I_C in the case at +1: from 0 to 1 around ε.
double rise(double opposed, Shape shape) {
    if (shape == Shape::crisp) return opposed > threshold ? 1 : 0;
    constexpr double half_width = 1 - threshold;
    const double t = std::clamp((opposed - threshold + half_width) / (2 * half_width), 0.0, 1.0);
    return shape == Shape::smooth ? t * t * (3 - 2 * t) : t;
}

}  // namespace

Cases memberships(double collision_index, Shape shape) {
    const auto named = [&](double opposed) { return rise(opposed, shape); };
    const double penetration = named(-collision_index), extraction = named(collision_index);
    return {.penetration = penetration, .sliding = 1 - penetration - extraction, .extraction = extraction};
}

Cases first_pass(double collision_index, Shape shape) {
    const Cases evidence = memberships(collision_index, shape);
    return {.penetration = evidence.penetration * high + (1 - evidence.penetration) * low,
            .sliding = evidence.sliding * high + (1 - evidence.sliding) * low,
            .extraction = evidence.extraction * high + (1 - evidence.extraction) * low};
}

Cases feedback(double collision_index, const Cases& previous, Shape shape) {
    const Cases evidence = memberships(collision_index, shape);
    return {.penetration = infer(previous.penetration, evidence.penetration),
            .sliding = infer(previous.sliding, evidence.sliding),
            .extraction = infer(previous.extraction, evidence.extraction)};
}

Vec3 displacement(const Cases& weights, const Vec3& motion, const Vec3& normal) {
    return weights.penetration * motion - weights.sliding * normal - weights.extraction * motion;
}

}  // namespace trocar::fuzzy
