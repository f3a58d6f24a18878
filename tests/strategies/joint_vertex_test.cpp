#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/strategies/fuzzy/paper_rules.h"
#include "tests/strategies/scenes.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::answer_of;
using contract::Scene;

Scene with_organ(Scene scene, SurfaceMesh rest, std::vector<Index> collided) {
    scene.organ = std::make_shared<const Organ>(make_organ("by hand", std::move(rest)));
    scene.positions = scene.organ->rest.positions;
    scene.velocities.assign(scene.positions.size(), Vec3::Zero());
    scene.detected.collided = std::move(collided);
    return scene;
}

/// A flat piece of organ under the tool's end.
Scene flat(const Vec3& motion) {
    return contract::single_vertex({0.3, 0.2, 1.5}, contract::flat_base({0.3, 0.2, 1.5}), motion);
}

/// Two collided vertices, 0 and 1. Facets 0 and 1 have both of them, 2 and 3 only vertex 0, 4 only vertex 1.
/// Facet 4 faces about +x, all others face +z.
Scene pair(const Vec3& motion) {
    SurfaceMesh rest;
    rest.positions = {{-0.5, 0, 2}, {0.5, 0, 2}, {0, 1, 2}, {0, -1, 2}, {-1, 0, 2}, {0.5, -0.2, 1}};
    rest.facets = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {0, 4, 3}, {1, 3, 5}};
    return with_organ(flat(motion), std::move(rest), {0, 1});
}

/// The tool, moving down, between two walls: vertex 0 of the left wall, which has four facets and faces +x,
/// and vertex 5 of the right one, which has three and faces −x.
Scene cleft() {
    const Vec3 left(-2.5, 0, 10), right(2.5, 0, 10);
    SurfaceMesh rest;
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(0, 0, -1)})
        rest.positions.emplace_back(left + way);
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0, -1, -1)})
        rest.positions.emplace_back(right + way);
    rest.facets = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 6, 7}, {5, 7, 8}, {5, 8, 6}};
    return with_organ(flat({0, 0, -1}), std::move(rest), {0, 5});
}

Vec3 normal_of(const Scene& scene, Index facet) { return scene.organ->rest_normals[facet]; }

Vec3 direction(const Scene& scene, const Options& options = {}) {
    return answer_of("joint-vertex", scene, options).displacements.at(0).displacement.normalized();
}

Vec3 expected_direction(const Vec3& motion, const Vec3& normal) {
    return fuzzy::displacement(fuzzy::paper_inference().first(motion.dot(normal)), motion, normal)
        .normalized();
}

TEST(JointVertex, MovesAllVerticesAlikeByTheLongestWayOut) {
    Scene scene = flat({0, 0, -2});
    scene.positions[1] = {1, 0, 2.5};
    scene.detected.collided = {0, 1};
    const Response response = answer_of("joint-vertex", scene, {{"normals", std::string("reference")}});
    // Straight down through the tip, as far as the higher one needs.
    ASSERT_EQ(response.displacements.size(), 2U);
    for (const auto& [vertex, displacement] : response.displacements) {
        EXPECT_TRUE(displacement.isApprox(Vec3(0, 0, -2.51), 1e-12)) << vertex;
    }
}

TEST(JointVertex, NormalsAreThoseOfTheStepOrThoseAtRest) {
    Scene scene = flat({1, 0, 0});
    for (std::size_t k = 1; k < scene.positions.size(); ++k)
        scene.positions[k].z() += 0.3 * (scene.positions[k].y() - 0.2);
    EXPECT_TRUE(direction(scene, {{"normals", std::string("reference")}}).isApprox(Vec3(0, 0, -1), 1e-12));
    EXPECT_TRUE(direction(scene).isApprox(Vec3(0, 0.3, -1).normalized(), 1e-12));
}

TEST(JointVertex, CountsEachFacetOnce) {
    const Vec3 motion = Vec3(1, 0, -1).normalized();
    const Scene scene = pair(motion);
    Vec3 once = Vec3::Zero(), each = Vec3::Zero();
    for (Index facet = 0; facet < 5; ++facet) once += normal_of(scene, facet);
    each = once + normal_of(scene, 0) + normal_of(scene, 1);
    EXPECT_TRUE(direction(scene).isApprox(expected_direction(motion, once.normalized()), 1e-12));
    const Vec3 counted_each = direction(scene, {{"shared-facets", std::string("each")}});
    EXPECT_TRUE(counted_each.isApprox(expected_direction(motion, each.normalized()), 1e-12));
    EXPECT_GT((direction(scene) - counted_each).norm(), 1e-3) << "the option changes nothing here";
}

TEST(JointVertex, TakesTheMotionAtTheCentroid) {
    Scene scene = pair({0, 0, 0});
    scene.before.rotation << 0, 1, 0, -1, 0, 0, 0, 0, 1;  // a quarter turn about the axis: none at (0, 0, 2)
    const Response response = answer_of("joint-vertex", scene);
    EXPECT_EQ(response.fallbacks, 2) << "every vertex lost its direction";
    EXPECT_EQ(response.displacements.size(), 2U);
    EXPECT_TRUE(answer_of("joint-vertex", scene, {{"fallback", std::string("stay")}}).displacements.empty());
}

TEST(JointVertex, CarriesOneWallOfACleftThroughTheTool) {
    // Section IV: "if the collision occurs in two opposite facets of the tool … the tool is crossed". The
    // wall with more facets decides.
    const Response joint = answer_of("joint-vertex", cleft());
    ASSERT_EQ(joint.displacements.size(), 2U);
    EXPECT_LT(2.5 + joint.displacements[1].displacement.x(), -4) << "the right wall, out on the left";
    const Response apart = answer_of("fuzzy-per-vertex", cleft());
    EXPECT_LT(-2.5 + apart.displacements.at(0).displacement.x(), -4);
    EXPECT_GT(2.5 + apart.displacements.at(1).displacement.x(), 4);
}

RC_GTEST_PROP(JointVertex, EqualsASlowReading, (std::uint32_t seed)) {
    const Scene scene = contract::random_scene(seed);
    std::set<Index> facets;
    Vec3 motion = Vec3::Zero(), normal = Vec3::Zero();
    for (const Index vertex : scene.detected.collided) {
        for (const Index facet : scene.organ->adjacency.ring(vertex)) facets.insert(facet);
        motion += ToolMotion(scene.before, scene.after).displacement_at(scene.positions[vertex]);
    }
    for (const Index facet : facets) {
        normal += facet_normal(scene.positions, scene.organ->rest.facets[facet]);
    }
    const Response response = answer_of("joint-vertex", scene);
    RC_PRE(response.fallbacks == 0);
    RC_ASSERT(response.displacements.size() == scene.detected.collided.size());
    const Vec3 expected = expected_direction(motion.normalized(), normal.normalized());
    for (const auto& [vertex, displacement] : response.displacements) {
        RC_ASSERT(displacement == response.displacements.front().displacement);
        RC_ASSERT((displacement.normalized() - expected).norm() < 1e-7);
    }
}

}  // namespace
}  // namespace trocar
