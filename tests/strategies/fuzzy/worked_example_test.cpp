// The example of strategies/worked_example.md, with the numbers that stand there.
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "strategies/fuzzy/fired_rules.h"
#include "strategies/fuzzy/vertex_inference.h"
#include "tests/strategies/fuzzy/paper_rules.h"
#include "tests/strategies/single_vertex.h"

namespace trocar::fuzzy {
namespace {

constexpr double shown = 0.51e-6;  // the page rounds to six decimals

const Vec3 vertex(0.3, 0.2, 1.5), motion(0, 0, -1);
const std::vector<FacetNormal> facets = {{.facet = 0, .normal = {0.28, 0, 0.96}},
                                         {.facet = 1, .normal = {-0.48, 0.64, 0.6}},
                                         {.facet = 2, .normal = {0, -0.96, 0.28}}};

/// What the page says of one facet.
struct Row {
    double index, penetration, sliding;  // I_C and its memberships
    Vec3 weights, vector;
};

const std::array<Row, 3> page = {{
    {-0.96, 0.931717, 0.068283, {0.931717, 0.068283, 0}, {-0.019119, 0, -0.997269}},
    {-0.6, 0.317173, 0.682827, {0.611961, 0.388039, 0}, {0.186259, -0.248345, -0.844785}},
    {-0.28, 0, 1, {0.111961, 0.888039, 0}, {0, 0.852517, -0.360612}},
}};

TEST(WorkedExample, FacetByFacet) {
    std::vector<FacetShare> shares;
    const Vec3 vector = vertex_vector(paper_inference(), {}, motion, facets, &shares);
    const RuleBase rules = read_rules(shipped_rules());
    ASSERT_EQ(shares.size(), page.size());
    for (std::size_t k = 0; k < page.size(); ++k) {
        SCOPED_TRACE(k);
        const FacetShare& share = shares[k];
        EXPECT_NEAR(share.collision_index, page.at(k).index, shown);
        const auto degrees = term_degrees(rules, Input::collision_index, share.collision_index);
        EXPECT_NEAR(degrees.at(0).degree, page.at(k).penetration, shown);
        EXPECT_NEAR(degrees.at(1).degree, page.at(k).sliding, shown);
        EXPECT_NEAR(share.weights.penetration, page.at(k).weights[0], shown);
        EXPECT_NEAR(share.weights.sliding, page.at(k).weights[1], shown);
        EXPECT_NEAR(share.weights.extraction, page.at(k).weights[2], shown);
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(share.vector[axis], page.at(k).vector[axis], shown);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(vector[axis], Vec3(0.167139, 0.604172, -2.202665)[axis], shown);
    }
}

TEST(WorkedExample, TheRulesThatFireAtTheSecondFacet) {
    const RuleBase rules = read_rules(shipped_rules());
    const std::vector<FiredRule> fired =
        fired_rules(rules, {.collision_index = -0.6, .previous = {0.931717, 0.068283, 0}, .first = false});
    // I_P was MEDIUM or HIGH, I_S LOW or MEDIUM, I_E LOW; each under penetration and under sliding.
    const std::array<double, 10> strengths = {0.043315, 0.093251, 0.273858, 0.589576, 0.273858,
                                              0.589576, 0.043315, 0.093251, 0.317173, 0.682827};
    ASSERT_EQ(fired.size(), strengths.size());
    for (std::size_t k = 0; k < fired.size(); ++k) {
        EXPECT_NEAR(fired[k].strength, strengths.at(k), 2e-6) << fired[k].rule->text;
    }
}

TEST(WorkedExample, TheVertexLeavesTheTool) {
    // A three-sided pyramid with these normals, its apex 1.5 mm above the flat end of the tool.
    std::vector<Vec3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 edge = facets[(k + 2) % 3].normal.cross(facets[k].normal);
        corners.emplace_back(vertex + (edge.z() < 0 ? edge : Vec3(-edge)));
    }
    const contract::Scene scene = contract::single_vertex(vertex, corners, motion);
    for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(scene.organ->rest_normals[k].isApprox(facets[k].normal, 1e-12)) << k;
    }
    const Response response = contract::answer_of("fuzzy-per-vertex", scene);
    ASSERT_EQ(response.displacements.size(), 1U);
    const Vec3 displacement = response.displacements[0].displacement;
    EXPECT_NEAR(displacement.norm(), 1.569960, shown);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(displacement[axis], Vec3(0.114580, 0.414180, -1.51)[axis], shown);
    }
}

}  // namespace
}  // namespace trocar::fuzzy
