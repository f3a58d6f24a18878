#include "common/tool/walk.h"

#include <algorithm>
#include <numbers>
#include <vector>

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

Pose turned(const Vec3& position, double angle) {
    return {.rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(), .position = position};
}

TEST(Walk, TurnsEvenlyAlongEachPieceOfAWay) {
    Walk walk(Pose{}, 30, dt, 0.5);  // full steps of 1 mm
    const std::vector<Pose> way{turned({2, 0, 0}, 0.8), turned({2, 1, 0}, 0.8), turned({2, 1, 2}, -1)};
    walk.go_along(way);
    // Half a millimetre from the start, then a millimetre further each, and what is left of 5 mm.
    const std::vector<Pose> expected{turned({0.5, 0, 0}, 0.2),   turned({1.5, 0, 0}, 0.6),
                                     turned({2, 0.5, 0}, 0.8),   turned({2, 1, 0.5}, 0.35),
                                     turned({2, 1, 1.5}, -0.55), turned({2, 1, 2}, -1)};
    ASSERT_EQ(walk.poses().size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_TRUE(walk.poses()[k].position.isApprox(expected[k].position, 1e-12)) << k;
        EXPECT_TRUE(walk.poses()[k].rotation.isApprox(expected[k].rotation, 1e-12)) << k;
    }
    EXPECT_EQ(walk.poses().back().position, way.back().position);
    EXPECT_EQ(walk.poses().back().rotation, way.back().rotation) << "exactly";
}

TEST(Walk, IsNotSlowedDownByPosesThatAreNearerThanAStep) {
    // 40 poses a millimetre apart, around a corner.
    std::vector<Pose> way;
    for (int k = 1; k <= 40; ++k) {
        const double gone = k;
        way.push_back(turned({std::min(gone, 25.0), std::max(0.0, gone - 25), 0}, 0.01 * gone));
    }
    Walk slow(Pose{}, 6, dt, 0), rapid(Pose{}, 360, dt, 0);  // 0.2 mm and 12 mm a step
    slow.go_along(way);
    rapid.go_along(way);
    EXPECT_EQ(slow.poses().size(), 201U) << "a step of phase 0, then 40 mm";
    ASSERT_EQ(rapid.poses().size(), 5U) << "0, 12, 24, 36 and 40 mm";
    for (std::size_t k = 0; k < 5; ++k) {
        const Pose& passed = slow.poses().at(std::min<std::size_t>(60 * k, 200));
        EXPECT_TRUE(rapid.poses()[k].position.isApprox(passed.position, 1e-12));
        EXPECT_TRUE(rapid.poses()[k].rotation.isApprox(passed.rotation, 1e-12));
    }
}

TEST(Walk, AWayOfOnePoseIsGoneStraight) {
    const Pose start = turned({1, 2, 3}, 0.3), end = turned({4, -2, 5}, 0.3);
    Walk along(start, 20, dt, 0.7), straight(start, 20, dt, 0.7);
    along.go_along(std::vector{end});
    straight.go_to(end.position);
    ASSERT_EQ(along.poses().size(), straight.poses().size());
    for (std::size_t k = 0; k < along.poses().size(); ++k) {
        EXPECT_TRUE(along.poses()[k].position.isApprox(straight.poses()[k].position, 1e-14));
        EXPECT_TRUE(along.poses()[k].rotation.isApprox(start.rotation, 1e-14));
    }
}

TEST(Walk, AWayOfNoPoseStaysForAStep) {
    const Pose start = turned({1, 2, 3}, 0.3);
    Walk walk(start, 20, dt, 0.5);
    walk.go_along({});
    ASSERT_EQ(walk.poses().size(), 1U);
    EXPECT_EQ(walk.poses()[0].position, start.position);
}

}  // namespace
}  // namespace trocar
