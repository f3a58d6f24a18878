#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/strategies/fuzzy/paper_rules.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::Scene;

Response answer(const Scene& scene, const Options& options = {}) {
    return contract::answer_of("fuzzy-per-vertex", scene, options);
}

Vec3 direction(const Scene& scene, const Options& options = {}) {
    const Response response = answer(scene, options);
    EXPECT_EQ(response.displacements.size(), 1U);
    EXPECT_EQ(response.fallbacks, 0);
    return response.displacements.at(0).displacement.normalized();
}

const Vec3 vertex(0.3, 0.2, 1.5);

/// A ridge along x: facets 0 and 1 lie on its +y side, 2 and 3 on its −y side, `slope` below the horizontal.
std::vector<Vec3> ridge(double slope) {
    const double down = -std::tan(slope);
    return {vertex + Vec3(1, 0, 0), vertex + Vec3(0, 1, down), vertex + Vec3(-1, 0, 0),
            vertex + Vec3(0, -1, down)};
}

TEST(FuzzyPerVertex, PenetrationGoesAlongTheMotionToTheExit) {
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, -2});
    const Response response = answer(scene);
    ASSERT_EQ(response.displacements.size(), 1U);
    EXPECT_EQ(response.displacements[0].vertex, 0);
    // Down through the flat tip at z = 0, and 0.01 mm further.
    EXPECT_TRUE(response.displacements[0].displacement.isApprox(Vec3(0, 0, -1.51), 1e-12));
}

TEST(FuzzyPerVertex, SlidingGoesAgainstTheNormal) {
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {1, 0, 0});
    EXPECT_TRUE(direction(scene).isApprox(Vec3(0, 0, -1), 1e-12));
}

TEST(FuzzyPerVertex, ExtractionGoesAgainstTheMotion) {
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, 2});
    EXPECT_TRUE(direction(scene).isApprox(Vec3(0, 0, -1), 1e-12));
}

TEST(FuzzyPerVertex, BetweenPenetrationAndSlidingIsBetweenTheirDirections) {
    // v_m at 45° to the normals: I = (½, ½, 0) in the first pass; without feedback the sum is ½ (v_m − n)
    // each.
    const Vec3 motion = Vec3(1, 0, -1).normalized();
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), motion);
    const Vec3 expected = (motion - Vec3(0, 0, 1)).normalized();
    EXPECT_TRUE(direction(scene, {{"feedback", false}}).isApprox(expected, 1e-4));
}

TEST(FuzzyPerVertex, TheRuleBaseSaysHowTheCasesPassIntoOneAnother) {
    // I_C = −0.8, 0.3858 of 0.5858 on the way from sliding to penetration.
    const Vec3 motion(0.6, 0, -0.8);
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), motion);
    const double t = 0.3858 / 0.5858;
    const auto expected = [&](double p) { return (p * motion - (1 - p) * Vec3(0, 0, 1)).normalized(); };
    const auto found = [&](const std::string& rules) {
        return direction(scene, {{"feedback", false}, {"rules", rules}});
    };
    EXPECT_TRUE(found("feedback").isApprox(expected(t), 1e-12));
    EXPECT_TRUE(found(fuzzy::smooth_rules()).isApprox(expected(1 - 2 * (1 - t) * (1 - t)), 1e-12));
    EXPECT_TRUE(found(fuzzy::crisp_rules()).isApprox(motion, 1e-12));
}

TEST(FuzzyPerVertex, FeedbackFollowsTheHandWorkedExample) {
    // Straight down onto a ridge of 60°: n = (0, ±sin 60°, cos 60°), I_C = −½ at every facet.
    const Scene scene = contract::single_vertex(vertex, ridge(std::numbers::pi / 3), {0, 0, -1});
    // μ_P(−½) = (½ − 0.7071 + 0.2929) / 0.5858, the rest is sliding.
    const double p0 = 0.0858 / 0.5858, s0 = 1 - p0;
    // Rule 6 for a weight w ≥ ½ with evidence e: terms MEDIUM 2 − 2w, HIGH 2w − 1.
    const auto upper = [](double w, double e) { return (2 - 2 * w) * e + (2 * w - 1) * (e + (1 - e) / 2); };
    // … and for w ≤ ½: LOW 1 − 2w, MEDIUM 2w.
    const auto lower = [](double w, double e) { return (1 - 2 * w) * e / 2 + 2 * w * e; };
    const double p1 = lower(p0, p0), s1 = upper(s0, s0);
    const double p2 = lower(p1, p0), s2 = upper(s1, s0);
    const double p3 = lower(p2, p0), s3 = upper(s2, s0);
    const double sine = std::sin(std::numbers::pi / 3), cosine = 0.5;
    const Vec3 left(0, sine, cosine), right(0, -sine, cosine), down(0, 0, -1);
    const Vec3 total = (p0 * down - s0 * left) + (p1 * down - s1 * left) + (p2 * down - s2 * right) +
                       (p3 * down - s3 * right);
    EXPECT_TRUE(direction(scene).isApprox(total.normalized(), 1e-12));
    EXPECT_TRUE(direction(scene, {{"aggregate", std::string("last")}})
                    .isApprox((p3 * down - s3 * right).normalized(), 1e-12));
    EXPECT_TRUE(direction(scene, {{"aggregate", std::string("mean-normal")}})
                    .isApprox((p3 * down - s3 * Vec3(0, 0, 1)).normalized(), 1e-12));
}

TEST(FuzzyPerVertex, StrongestFirstFeedsTheFacetsByTheirIndex) {
    // Two steep facets and two flat ones: with "last" the answer is the flat facet's in the ring's order …
    std::vector<Vec3> corners = {vertex + Vec3(1, 0, 0), vertex + Vec3(0, 1, -5), vertex + Vec3(-1, 0, 0),
                                 vertex + Vec3(0, -1, 0)};
    const Scene scene = contract::single_vertex(vertex, corners, {0, 0, -1});
    const Options ring = {{"aggregate", std::string("last")}, {"feedback", false}};
    Options strongest = ring;
    strongest["order"] = std::string("strongest-first");
    EXPECT_TRUE(direction(scene, ring).isApprox(Vec3(0, 0, -1), 1e-12));
    // … and a steep facet's, n = (0, 5, 1) / √26, when the strongest come first.
    EXPECT_TRUE(direction(scene, strongest).isApprox(-Vec3(0, 5, 1).normalized(), 1e-9));
}

TEST(FuzzyPerVertex, ReferenceNormalsAreThoseAtRest) {
    Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {1, 0, 0});
    for (std::size_t k = 1; k < scene.positions.size(); ++k)
        scene.positions[k].z() += 0.3 * scene.positions[k].y();
    const Vec3 tilted = Vec3(0, -0.3, 1).normalized();
    EXPECT_TRUE(direction(scene, {{"normals", std::string("reference")}}).isApprox(Vec3(0, 0, -1), 1e-12));
    EXPECT_LT((direction(scene, {{"normals", std::string("current")}}) + tilted).norm(), 0.1);
}

TEST(FuzzyPerVertex, CasePenetrationIgnoresTheNormals) {
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {1, 0, 0});
    EXPECT_TRUE(direction(scene, {{"case", std::string("penetration")}}).isApprox(Vec3(1, 0, 0), 1e-12));
}

TEST(FuzzyPerVertex, FallsBackToTheNearestFaceWithoutMotion) {
    const Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, 0});
    const Response response = answer(scene), staying = answer(scene, {{"fallback", std::string("stay")}});
    EXPECT_EQ(response.fallbacks, 1);
    EXPECT_EQ(staying.fallbacks, 1);
    EXPECT_TRUE(staying.displacements.empty());
    EXPECT_TRUE(response.displacements.at(0).displacement.isApprox(Vec3(0, 0, -1.51), 1e-12));
}

TEST(FuzzyPerVertex, AMotionBelowAMillionthOfTheClearanceIsNone) {
    const auto fallbacks = [](double way) {
        return answer(contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, -way})).fallbacks;
    };
    EXPECT_EQ(fallbacks(0.9e-8), 1);
    EXPECT_EQ(fallbacks(1.1e-8), 0);
}

TEST(FuzzyPerVertex, FallsBackWhereTheFacetsCancel) {
    // A fold: two facets face up, two face down, so sliding normals sum to nothing.
    const std::vector<Vec3> fold = {vertex + Vec3(1, 0, 0), vertex + Vec3(0, 1, 0), vertex + Vec3(-1, 0, 0),
                                    vertex + Vec3(0, 1, 0)};
    const Scene scene = contract::single_vertex(vertex, fold, {1, 0, 0});
    const Response response = answer(scene, {{"feedback", false}});
    EXPECT_EQ(response.fallbacks, 1);
}

}  // namespace
}  // namespace trocar
