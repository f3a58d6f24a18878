#include <gtest/gtest.h>

#include "experiments/turns/walks.h"
#include "strategies/motion_vector.h"
#include "tests/experiments/turning_vertex.h"

namespace trocar {
namespace {

/// Whether there is a direction towards which all normals lean: Rosenblatt's perceptron finds it.
bool faces_one_way(const std::vector<Vec3>& normals) {
    Vec3 direction = Vec3::Zero();
    const auto leans_away = [&](const Vec3& normal) { return normal.dot(direction) <= 0; };
    for (int attempt = 0; attempt < 10'000; ++attempt) {
        const auto away = std::ranges::find_if(normals, leans_away);
        if (away == normals.end()) return true;
        direction += *away;
    }
    return false;
}

TEST(SingleVertex, IsOneVertexInsideTheToolWithAProperRing) {
    for (const std::uint64_t seed : seeds_to(200)) {
        const auto vertex = vertex_of(seed);
        const auto& [positions, facets] = vertex.organ.rest;
        EXPECT_TRUE(PlacedTool(*vertex.tool, Pose{}).contains(positions[0]));
        const std::size_t around = vertex.organ.adjacency.ring(0).size();
        EXPECT_EQ(around, facets.size());
        EXPECT_TRUE(around >= 5 && around <= 7) << around;
        EXPECT_FALSE(vertex.organ.adjacency.on_boundary(0));
        EXPECT_TRUE(faces_one_way(vertex.organ.rest_normals)) << seed;
        for (std::size_t k = 1; k < positions.size(); ++k) {
            const double edge = (positions[k] - positions[0]).norm();
            EXPECT_TRUE(edge > 2 - 1e-9 && edge < 5 + 1e-9) << edge;
        }
    }
}

TEST(SingleVertex, HasTheMotionThatItIsGiven) {
    const auto vertex = vertex_of(1);
    with_contact(vertex, {vertex.first_side, vertex.organ.rest.positions}, [&](const Contact& contact) {
        EXPECT_TRUE(motion_vector(contact, contact.positions[0]).value().isApprox(vertex.first_side, 1e-12));
        EXPECT_EQ(contact.tool.pose().position, Vec3::Zero());
        EXPECT_EQ(contact.near_facets.size(), contact.organ.rest.facets.size());
        EXPECT_EQ(contact.near_vertices.size(), contact.organ.rest.positions.size());
    });
}

TEST(WalkOfMotions, GoesByAQuarterOfADegreePastEveryDirection) {
    const auto walk = turns::walk_of_motions(vertex_of(1));
    ASSERT_EQ(walk.size(), 12U * 180 * 4 + 1);
    for (std::size_t k = 0; k + 1 < walk.size(); ++k) {
        ASSERT_NEAR(walk[k].norm(), 1, 1e-12);
        ASSERT_NEAR(angle_between(walk[k], walk[k + 1]), 0.25, 1e-6);
    }
    EXPECT_TRUE(walk.front().isApprox(walk.back(), 1e-12));
    for (const std::uint64_t seed : seeds_to(50)) {
        const Vec3 any = vertex_of(seed).line;
        double nearest = 180;
        for (const Vec3& motion : walk) nearest = std::min(nearest, angle_between(any, motion));
        EXPECT_LT(nearest, 15.2);
    }
}

TEST(FindSwitches, FindsWhereAnotherSideOfThePrismIsNearest) {
    // Of a prism of 12 sides: the largest of x · n_k − r cos 15° and the two ends' −z and z − 80.
    const auto nearest = [](const Vec3& x) {
        std::vector<double> heights{-x.z(), x.z() - 80};
        for (int k = 0; k < 12; ++k) {
            heights.push_back(turned(15 + 30 * k).dot(x) - 4 * std::cos(15 * degree));
        }
        return std::ranges::max_element(heights) - heights.begin();
    };
    for (const std::uint64_t seed : seeds_to(20)) {
        const auto vertex = vertex_of(seed);
        const auto switches = turns::find_switches(vertex);
        EXPECT_FALSE(switches.empty());
        for (const auto& [positions] : switches) {
            EXPECT_NE(nearest(positions[0][0]), nearest(positions[1][0])) << seed;
            for (std::size_t k = 0; k < positions[0].size(); ++k)
                EXPECT_NEAR((positions[1][k] - positions[0][k]).norm(), 0.01, 1e-9);
        }
    }
}

}  // namespace
}  // namespace trocar
