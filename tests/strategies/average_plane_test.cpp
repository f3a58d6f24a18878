#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/strategies/scenes.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::answer_of;

const Vec3 vertex(0.5, 0.2, 3);

/// Around a vertex, flat facets whose common normal leans from the axis (+z) towards +x by 45°.
contract::Scene leaning() {
    return contract::single_vertex(
        vertex,
        {vertex + Vec3(1, 0, -1), vertex + Vec3(0, 1, 0), vertex + Vec3(-1, 0, 1), vertex + Vec3(0, -1, 0)},
        {0, 0, -1});
}

Vec3 displacement_in(const contract::Scene& scene, const Options& options = {}) {
    const Response response = answer_of("average-plane", scene, options);
    EXPECT_EQ(response.displacements.size(), 1U);
    EXPECT_EQ(response.fallbacks, 0);
    return response.displacements.at(0).displacement;
}

TEST(AveragePlane, GoesBeyondThePlaneThatTouchesTheToolOnTheOrgansSide) {
    // m = +x without the part along the axis; the square tool reaches to x = −4.
    EXPECT_TRUE(displacement_in(leaning()).isApprox(Vec3(-4.51, 0, 0), 1e-12));
}

TEST(AveragePlane, ThroughTheAxisProjectsOntoThePlane) {
    EXPECT_TRUE(
        displacement_in(leaning(), {{"plane", std::string("axis")}}).isApprox(Vec3(-0.5, 0, 0), 1e-12));
}

TEST(AveragePlane, AveragesTheUnitNormalsWhateverTheFacetsAreas) {
    // Two facets with normal +x, small, and two with normal +y, large: m = (1, 1, 0) / √2. The plane touches
    // the square tool's side x + y = −4.
    const std::vector<Vec3> corners = {vertex + Vec3(-5, 0, 0), vertex + Vec3(0, 0, 1),
                                       vertex + Vec3(0, -1, 0), vertex + Vec3(0, 0, -1)};
    const contract::Scene scene = contract::single_vertex(vertex, corners, {0, 0, -1});
    const auto& normals = scene.organ->rest_normals;
    ASSERT_TRUE(normals[0].isApprox(Vec3(0, 1, 0)) && normals[1].isApprox(Vec3(1, 0, 0)));
    const Vec3 m = Vec3(1, 1, 0).normalized();
    const double way = m.dot(vertex) + 4 / std::numbers::sqrt2 + 0.01;
    EXPECT_TRUE(displacement_in(scene).isApprox(-way * m, 1e-12));
}

TEST(AveragePlane, NeighboursMayGetDifferentPlanes) {
    // The defect that section III names: the same place, the facets turned, another plane.
    contract::Scene other = leaning();
    for (std::size_t k = 1; k < other.positions.size(); ++k) {
        Vec3& corner = other.positions[k];
        corner.head<2>() = 2 * vertex.head<2>() - corner.head<2>();
    }
    EXPECT_GT(displacement_in(leaning()).normalized().dot(Vec3(-1, 0, 0)), 0.99);
    EXPECT_LT(displacement_in(other).normalized().dot(Vec3(-1, 0, 0)), -0.99);
}

TEST(AveragePlane, WithoutAPlaneDoesAsCylinderAxisDoes) {
    const contract::Scene scene = contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, -1});
    const Response response = answer_of("average-plane", scene);
    EXPECT_EQ(response.fallbacks, 1);
    EXPECT_EQ(response.displacements.at(0).displacement,
              answer_of("cylinder-axis", scene).displacements.at(0).displacement);
    const Response other = answer_of("average-plane", scene, {{"fallback", std::string("nearest-face")}});
    EXPECT_EQ(other.fallbacks, 1);
    EXPECT_EQ(other.displacements.at(0).displacement,
              answer_of("nearest-face", scene).displacements.at(0).displacement);
}

TEST(AveragePlane, NeedsAThousandthAcrossTheAxis) {
    const auto fallbacks = [](double lean) {
        const Vec3 v = vertex;
        const std::vector<Vec3> corners = {v + Vec3(1, 0, -lean), v + Vec3(0, 1, 0), v + Vec3(-1, 0, lean),
                                           v + Vec3(0, -1, 0)};
        return answer_of("average-plane", contract::single_vertex(v, corners, {0, 0, -1})).fallbacks;
    };
    EXPECT_EQ(fallbacks(0.00099), 1);
    EXPECT_EQ(fallbacks(0.00101), 0);
}

RC_GTEST_PROP(AveragePlane, EndsBeyondEveryPointOfTheTool, (std::uint32_t seed)) {
    const contract::Scene scene = contract::random_scene(seed);
    const Response response = answer_of("average-plane", scene);
    RC_PRE(response.fallbacks == 0);
    const Vec3 axis = scene.after.rotation.col(2);
    for (const auto& [vertex_moved, displacement] : response.displacements) {
        RC_ASSERT(std::abs(displacement.dot(axis)) < 1e-10);
        const Vec3 outwards = displacement.normalized(), end = scene.positions[vertex_moved] + displacement;
        double furthest = -1e300;
        for (const Vec3& p : scene.tool->mesh.positions) {
            furthest = std::max(furthest, outwards.dot(scene.after.to_world(p)));
        }
        RC_ASSERT(std::abs(outwards.dot(end) - furthest - scene.clearance) < 1e-9);
    }
}

}  // namespace
}  // namespace trocar
