#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/strategies/scenes.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::answer_of;

TEST(CylinderAxis, GoesOrthogonallyAwayFromTheAxis) {
    // A square tool with corners 4 mm from the axis: along (1, 1, 0) its side is 4 / √2 = 2 √2 away.
    const Response response = answer_of(
        "cylinder-axis", contract::single_vertex({1, 1, 7}, contract::flat_base({1, 1, 7}), {0, 0, -2}));
    const double way = std::numbers::sqrt2 + 0.01;
    ASSERT_EQ(response.displacements.size(), 1U);
    EXPECT_TRUE(response.displacements[0].displacement.isApprox(way * Vec3(1, 1, 0).normalized(), 1e-12));
    EXPECT_EQ(response.fallbacks, 0);
}

TEST(CylinderAxis, LeavesThroughTheSideThatIsInTheWay) {
    // At 30° from the x axis the side x + y = 4, moved out by g, is met at r = (4 + 0.01 √2) / (cos 30° + sin
    // 30°).
    const double cosine = std::numbers::sqrt3 / 2, sine = 0.5, start = 1.5;
    const Vec3 x(start * cosine, start * sine, 7);
    const Response response =
        answer_of("cylinder-axis", contract::single_vertex(x, contract::flat_base(x), {0, 0, -2}));
    const double way = (4 + 0.01 * std::numbers::sqrt2) / (cosine + sine) - start;
    EXPECT_TRUE(response.displacements.at(0).displacement.isApprox(way * Vec3(cosine, sine, 0), 1e-12));
}

TEST(CylinderAxis, OnTheAxisTakesAFixedDirectionOfTheTool) {
    const Vec3 x(0, 0, 3);
    contract::Scene scene = contract::single_vertex(x, contract::flat_base(x), {0, 0, -2});
    const Response response = answer_of("cylinder-axis", scene);
    EXPECT_EQ(response.fallbacks, 1);
    const Vec3 moved = response.displacements.at(0).displacement;
    EXPECT_NEAR(moved.z(), 0, 1e-12);
    EXPECT_GT(moved.norm(), 2.8);
    // It turns with the tool.
    scene.after.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const Vec3 turned = answer_of("cylinder-axis", scene).displacements.at(0).displacement;
    EXPECT_TRUE(turned.isApprox(scene.after.rotation * moved, 1e-12));
}

RC_GTEST_PROP(CylinderAxis, MovesAlongTheRadiusOnly, (std::uint32_t seed)) {
    const contract::Scene scene = contract::random_scene(seed);
    const Vec3 axis = scene.after.rotation.col(2), tip = scene.after.position;
    for (const auto& [vertex, displacement] : answer_of("cylinder-axis", scene).displacements) {
        const Vec3 from_tip = scene.positions[vertex] - tip, radius = from_tip - axis.dot(from_tip) * axis;
        RC_ASSERT(std::abs(displacement.dot(axis)) < 1e-10);
        RC_ASSERT(displacement.normalized().dot(radius.normalized()) > 1 - 1e-10);
    }
}

}  // namespace
}  // namespace trocar
