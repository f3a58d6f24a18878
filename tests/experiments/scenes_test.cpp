#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/draws.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene.h"
#include "experiments/scenes/walk.h"

namespace trocar {
namespace {

constexpr double dt = 1.0 / 30;

/// An organ, its queries and a tool, to lay scenes out on.
struct Stage {
    explicit Stage(const std::string& formula) : organ(make_organ_by_formula(formula)) {}
    [[nodiscard]] SceneInputs inputs(double speed, std::uint64_t seed) const {
        return {
            .organ = organ, .organ_queries = queries, .tool = tool, .speed = speed, .dt = dt, .seed = seed};
    }
    Organ organ;
    SurfaceQueries queries{organ.rest};
    Tool tool = make_prism(12);
};

TEST(Draws, AreTheSameForTheSameArgumentsAndDifferOtherwise) {
    EXPECT_EQ(draw(3, 7), draw(3, 7));
    EXPECT_NE(draw(3, 7), draw(3, 8));
    EXPECT_NE(draw(3, 7), draw(4, 7));
}

TEST(Draws, AreUniform) {
    double sum = 0, squares = 0;
    constexpr int count = 100'000;
    for (int k = 0; k < count / 4; ++k) {
        for (const double u : draw(11, k)) {
            ASSERT_TRUE(u >= 0 && u < 1);
            sum += u;
            squares += u * u;
        }
    }
    EXPECT_NEAR(sum / count, 1.0 / 2, 0.005);
    EXPECT_NEAR(squares / count, 1.0 / 3, 0.005);
}

TEST(Placement, IsOnTheSurfaceWithItsNormal) {
    const Stage stage("sphere@4mm");
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Placement placement = place(stage.inputs(100, seed), 12);
        EXPECT_LT(stage.queries.distance(placement.entry), 1e-9);
        EXPECT_GT(placement.normal.dot(placement.entry.normalized()), 0.99);
        EXPECT_NEAR(placement.normal.norm(), 1, 1e-12);
        EXPECT_NEAR(placement.tangent.norm(), 1, 1e-12);
        EXPECT_NEAR(placement.tangent.dot(placement.normal), 0, 1e-12);
        EXPECT_TRUE(placement.phase >= 0 && placement.phase < 1);
    }
}

TEST(Placement, DoesNotDependOnTheSpeed) {
    const Stage stage("sphere@4mm");
    EXPECT_EQ(place(stage.inputs(20, 5), 12).entry, place(stage.inputs(400, 5), 12).entry);
}

TEST(Placement, IsUniformByArea) {
    // A third of a square sheet's inner part gets a third of the points, although its facets are as many
    // anywhere.
    const Stage stage("sheet@6mm");
    int left = 0;
    constexpr int count = 3000;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const Vec3 entry = place(stage.inputs(100, seed), 12).entry;
        ASSERT_LE(entry.head<2>().cwiseAbs().maxCoeff(), 60 - 8 + 1e-9)
            << "nearer than two radii to the boundary";
        if (entry.x() < -52.0 / 3) ++left;
    }
    EXPECT_NEAR(left, count / 3.0, 4 * std::sqrt(count * 2.0 / 9));
}

TEST(Placement, RefusesOrgansThatAreTooThinEverywhere) {
    SurfaceMesh flat = make_organ_by_formula("sphere@4mm").rest;
    for (Vec3& position : flat.positions) position *= 0.25;  // 20 mm across
    Stage stage("sphere@8mm");
    const Organ thin = make_organ("thin", flat);
    const SurfaceQueries queries(thin.rest);
    SceneInputs inputs{
        .organ = thin, .organ_queries = queries, .tool = stage.tool, .speed = 100, .dt = dt, .seed = 1};
    try {
        (void)place(inputs, 12);
        FAIL() << "no error";
    } catch (const PlacementError& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("\"thin\""), testing::HasSubstr("24 mm")));
    }
}

TEST(Walk, TheFirstStepIsThePhaseAndTheLastEndsExactly) {
    Walk walk(Pose{}, 30, dt, 0.25);  // full steps of 1 mm
    walk.go_to({0, 0, -3});
    std::vector<double> depths;
    for (const Pose& pose : walk.poses()) depths.push_back(-pose.position.z());
    EXPECT_THAT(depths, testing::Pointwise(testing::DoubleNear(1e-12), {0.25, 1.25, 2.25, 3.0}));
    EXPECT_EQ(depths.back(), 3);
}

TEST(Walk, ADistanceOfWholeStepsTakesNoExtraStep) {
    Walk walk(Pose{}, 3, 0.1, 0);  // 0.3 mm a step, which is no binary fraction
    walk.stay(0.1);
    walk.go_to({0, 0, 3});
    EXPECT_EQ(walk.poses().size(), 11U);
}

TEST(Walk, AStepLongerThanTheWayEndsAtItsEnd) {
    Walk walk(Pose{}, 2000, dt, 0.9);
    walk.go_to({0, 0, 15});
    ASSERT_EQ(walk.poses().size(), 1U);
    EXPECT_EQ(walk.poses()[0].position, Vec3(0, 0, 15));
}

class Penetration : public testing::TestWithParam<double> {};

TEST_P(Penetration, GoesInTo12mmHoldsComesBackAndRests) {
    const Stage stage("sphere@6mm");
    const SceneInputs inputs = stage.inputs(GetParam(), 2);
    const ScenePlan plan = find_scene("penetration").plan(inputs);
    const Placement& at = plan.placement;
    const auto height = [&](const Pose& pose) { return at.normal.dot(pose.position - at.entry); };

    EXPECT_NEAR(height(plan.start), 3, 1e-12);
    double lowest = 0;
    std::size_t at_bottom = 0, resting = 0;
    for (const Pose& pose : plan.poses) {
        EXPECT_TRUE(pose.direction_to_world(Vec3::UnitZ()).isApprox(at.normal, 1e-12)) << "axis along n";
        const Vec3 beside = pose.position - at.entry - height(pose) * at.normal;
        EXPECT_LT(beside.norm(), 1e-9) << "along n only";
        lowest = std::min(lowest, height(pose));
        if (std::abs(height(pose) + 12) < 1e-9) ++at_bottom;
        if (std::abs(height(pose) - 3) < 1e-9) ++resting;
    }
    EXPECT_NEAR(lowest, -12, 1e-12) << "the same at every speed";
    EXPECT_EQ(at_bottom, 1 + 15U) << "arrival and half a second at 30 Hz";
    EXPECT_EQ(resting, 1 + 30U);

    double longest = 0;
    for (std::size_t k = 1; k < plan.poses.size(); ++k) {
        longest = std::max(longest, (plan.poses[k].position - plan.poses[k - 1].position).norm());
    }
    EXPECT_LE(longest, GetParam() * dt + 1e-9);
    EXPECT_NEAR((plan.poses[0].position - plan.start.position).norm(),
                std::min(15.0, at.phase * GetParam() * dt), 1e-9);
}

TEST_P(Penetration, ItsWindowIsWhereTheToolMeetsTheOrganAtRest) {
    const Stage stage("sphere@6mm");
    const ScenePlan plan = find_scene("penetration").plan(stage.inputs(GetParam(), 2));
    ASSERT_EQ(plan.window.size(), plan.poses.size());
    for (std::size_t k = 0; k < plan.poses.size(); ++k) {
        const double height = plan.placement.normal.dot(plan.poses[k].position - plan.placement.entry);
        // The flat end meets the sphere a little before or after its middle does.
        if (std::abs(height) > 0.5) {
            EXPECT_EQ(plan.window[k], height < 0) << height;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Speeds, Penetration, testing::Values(20, 100, 400, 2000));

TEST(Scenes, AreFoundByName) {
    EXPECT_EQ(find_scene("penetration").name, "penetration");
    EXPECT_THROW(find_scene("penetratoin"), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
