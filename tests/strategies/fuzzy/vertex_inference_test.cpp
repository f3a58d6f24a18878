#include "strategies/fuzzy/vertex_inference.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "strategies/fuzzy/fired_rules.h"
#include "tests/random_numbers.h"
#include "tests/strategies/fuzzy/paper_rules.h"
#include "tests/strategies/single_vertex.h"

namespace trocar::fuzzy {
namespace {

using testing_support::random_direction;
using testing_support::random_number;

std::vector<FacetNormal> random_facets() {
    std::vector<FacetNormal> facets;
    const auto count = static_cast<Index>(std::lround(random_number(1, 9)));
    for (Index k = 0; k < count; ++k) facets.push_back({.facet = k, .normal = random_direction()});
    return facets;
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

RC_GTEST_PROP(VertexVector, IsTheSameForTheOppositeMotion, ()) {
    // I_P and I_E change places, and so do the vectors they weigh.
    const std::vector<FacetNormal> facets = random_facets();
    const Vec3 motion = random_direction();
    for (const Aggregate aggregate : {Aggregate::sum, Aggregate::last, Aggregate::mean_normal}) {
        for (const bool feedback : {true, false}) {
            const VertexReading reading{.aggregate = aggregate, .feedback = feedback};
            const Vec3 there = vertex_vector(paper_inference(), reading, motion, facets);
            const Vec3 back = vertex_vector(paper_inference(), reading, -motion, facets);
            RC_ASSERT((there - back).norm() < 1e-12);
        }
    }
}

/// How far 0.1° may turn the direction, from the shipped rules' slopes, where |d| ≥ 0.1 N. Memberships of I_C
/// have the slope 1/0.5858; a weight's slope is at most 1 in the weight before and 1 in the evidence, so the
/// j-th facet's weights move by j δ at most, with δ = 0.1°/0.5858. I_P, I_E and I_S of N facets together move
/// d by 3 δ N (N + 1) / 2, and the turned unit vector itself by N · 0.1°.
double allowed_turn(std::size_t facets) {
    const double turn = 0.1 * std::numbers::pi / 180, delta = turn / 0.5858;
    const auto count = static_cast<double>(facets);
    return std::asin(std::min(1.0, (1.5 * delta * (count + 1) + turn) / 0.1));
}

RC_GTEST_PROP(VertexVector, IsContinuous, ()) {
    std::vector<FacetNormal> facets = random_facets();
    Vec3 motion = random_direction();
    const Vec3 before = vertex_vector(paper_inference(), {}, motion, facets);
    RC_PRE(before.norm() >= 0.1 * static_cast<double>(facets.size()));
    const auto turned = static_cast<std::size_t>(random_number(0, static_cast<double>(facets.size()) + 0.99));
    Vec3& vector = turned == facets.size() ? motion : facets[turned].normal;
    const Vec3 axis = vector.cross(random_direction()).normalized();
    vector = Eigen::AngleAxisd(0.1 * std::numbers::pi / 180, axis) * vector;
    const Vec3 after = vertex_vector(paper_inference(), {}, motion, facets);
    RC_ASSERT(angle_between(before, after) <= allowed_turn(facets.size()));
}

TEST(VertexVector, JumpsWhereTheCasesDo) {
    // The continuity above is the rule base's, not the machine's: with crisp cases 0.1° turn it by 45°.
    const Inference crisp(read_rules(crisp_rules()));
    const std::vector<FacetNormal> facets(4, {.facet = 0, .normal = Vec3(0, 0, 1)});
    const auto direction = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return vertex_vector(crisp, {}, {std::sin(angle), 0, -std::cos(angle)}, facets);
    };
    EXPECT_NEAR(angle_between(direction(44.95), direction(45.05)), std::numbers::pi / 4, 2e-3);
    EXPECT_LT(angle_between(direction(44.75), direction(44.85)), 2e-3);
}

RC_GTEST_PROP(JointVertex, EqualsOnePassPerVertexWhereOneVertexCollidesAndItsNormalsAgree, ()) {
    const Vec3 vertex(0.3, 0.2, 1.5);
    const Eigen::AngleAxisd turn(random_number(0, 3), random_direction());
    std::vector<Vec3> corners = contract::flat_base(vertex);
    for (Vec3& corner : corners) corner = vertex + turn * (corner - vertex);
    const contract::Scene scene = contract::single_vertex(vertex, corners, random_direction());
    const Response joint = contract::answer_of("joint-vertex", scene);
    const Response alone = contract::answer_of("fuzzy-per-vertex", scene, {{"feedback", false}});
    RC_ASSERT(joint.displacements.size() == 1U);
    RC_ASSERT(alone.displacements.size() == 1U);
    RC_ASSERT((joint.displacements[0].displacement - alone.displacements[0].displacement).norm() < 1e-9);
}

RC_GTEST_PROP(FiredRules, AverageToTheWeights, ()) {
    const RuleBase rules = read_rules(shipped_rules());
    const Evidence evidence{.collision_index = random_number(-1, 1),
                            .previous = {random_number(0, 1), random_number(0, 1), random_number(0, 1)},
                            .first = random_number(0, 1) < 0.3};
    std::array<double, 3> sums{}, strengths{};
    for (const auto& [rule, strength] : fired_rules(rules, evidence)) {
        for (const auto& [output, term] : rule->then) {
            sums.at(output) += strength * rules.outputs.at(output).terms.at(term).weight;
            strengths.at(output) += strength;
        }
    }
    const Inference& inference = paper_inference();
    const Weights weights = evidence.first ? inference.first(evidence.collision_index)
                                           : inference.further(evidence.collision_index, evidence.previous);
    RC_ASSERT(std::abs(sums[0] / strengths[0] - weights.penetration) < 1e-12);
    RC_ASSERT(std::abs(sums[1] / strengths[1] - weights.sliding) < 1e-12);
    RC_ASSERT(std::abs(sums[2] / strengths[2] - weights.extraction) < 1e-12);
}

}  // namespace
}  // namespace trocar::fuzzy
