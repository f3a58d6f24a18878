#include "common/tool/walk.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trocar {
namespace {

constexpr double dt = 1.0 / 30;

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

TEST(Walk, TurnsAboutItsTipAtTheSpeedOfTheRim) {
    Pose start;
    start.position = {1, 2, 3};
    Walk walk(start, 30, dt, 0);  // 1 mm a step, at 4 mm from the axis a quarter of a radian
    walk.stay(dt);
    walk.turn(Vec3::UnitZ(), std::numbers::pi, 4);
    const auto& poses = walk.poses();
    ASSERT_EQ(poses.size(), 1 + 13U) << "12 full steps of 0.25 rad, and what is left of π";
    for (std::size_t k = 1; k < poses.size(); ++k) {
        EXPECT_EQ(poses[k].position, start.position);
        const Eigen::AngleAxisd turned(poses[k].rotation);
        EXPECT_NEAR(turned.angle(), std::min(0.25 * static_cast<double>(k), std::numbers::pi), 1e-12);
    }
    EXPECT_TRUE(poses.back().rotation.isApprox(Vec3(-1, -1, 1).asDiagonal().toDenseMatrix(), 1e-12));
}

}  // namespace
}  // namespace trocar
