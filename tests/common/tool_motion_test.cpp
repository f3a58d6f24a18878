#include "common/tool/tool_motion.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace trocar {
namespace {

constexpr double negligible = 1e-8;

Pose turned(double angle, const Vec3& about, const Vec3& position) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(angle, about.normalized()).toRotationMatrix();
    pose.position = position;
    return pose;
}

TEST(ToolMotion, TranslationIsTheSameEverywhere) {
    const ToolMotion motion(turned(0.4, {1, 2, 3}, {0, 0, 0}), turned(0.4, {1, 2, 3}, {0, 3, 4}));
    for (const Vec3& point : {Vec3(0, 0, 0), Vec3(1e3, -50, 7)}) {
        EXPECT_EQ(motion.displacement_at(point), Vec3(0, 3, 4));
        EXPECT_TRUE(motion.direction_at(point, negligible)->isApprox(Vec3(0, 0.6, 0.8)));
    }
}

TEST(ToolMotion, AToolHeldStillHasNoDirection) {
    const Pose pose = turned(1.1, {3, 1, 2}, {17, 4, -9});
    const ToolMotion motion(pose, pose);
    EXPECT_EQ(motion.displacement_at({1, 2, 3}), Vec3(0, 0, 0));
    EXPECT_FALSE(motion.direction_at({1, 2, 3}, negligible));
    EXPECT_FALSE(motion.direction_at({1, 2, 3}, 0));
}

TEST(ToolMotion, MaterialFollowsThePoses) {
    const Pose before = turned(0.2, {1, 0, 0}, {1, 2, 3}), after = turned(0.9, {0, 1, 1}, {4, 2, -1});
    const ToolMotion motion(before, after);
    const Vec3 material(3, -2, 5);  // in the tool's frame
    const Vec3 moved = after.to_world(material) - before.to_world(material);
    EXPECT_TRUE(motion.displacement_at(after.to_world(material)).isApprox(moved, 1e-12));
}

TEST(ToolMotion, OnTheAxisOfATurnThereIsNoDirection) {
    const ToolMotion motion(turned(0, Vec3::UnitZ(), {0, 0, 0}), turned(0.3, Vec3::UnitZ(), {0, 0, 0}));
    EXPECT_FALSE(motion.direction_at({0, 0, 7}, negligible));
    const auto beside = motion.direction_at({1, 0, 7}, negligible);
    ASSERT_TRUE(beside);
    EXPECT_GT(beside->y(), 0.9);
}

/// A screw motion: the pose after `angle` of a turn about a line that advances as it turns.
Pose screwed(double angle) {
    const Vec3 line_point(3, -1, 2), axis = Vec3(1, 2, 2) / 3;
    Pose pose = turned(angle, axis, {0, 0, 0});
    pose.position = line_point + pose.rotation * (Vec3(40, 0, 5) - line_point) + 7 * angle * axis;
    return pose;
}

TEST(ToolMotion, UnderRotationItsDirectionIsThatOfFiniteDifferences) {
    // The velocity of a point of the material, by central differences of its path, against v_m of a short
    // step around the same moment.
    constexpr double moment = 0.8, half_step = 1e-4, difference = 1e-6;
    const ToolMotion motion(screwed(moment - half_step), screwed(moment + half_step));
    for (const Vec3& material : {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(-2, 3, 80), Vec3(0, -4, 20)}) {
        const Vec3 velocity =
            screwed(moment + difference).to_world(material) - screwed(moment - difference).to_world(material);
        const auto direction =
            motion.direction_at(screwed(moment + half_step).to_world(material), negligible);
        ASSERT_TRUE(direction);
        EXPECT_TRUE(direction->isApprox(velocity.normalized(), 1e-7));
    }
    EXPECT_GT(motion.direction_at(screwed(moment).to_world({4, 0, 0}), negligible)
                  ->cross(*motion.direction_at(screwed(moment).to_world({0, 0, 80}), negligible))
                  .norm(),
              0.1)
        << "it depends on the point";
}

TEST(ToolMotion, AnOrganThatMovesCountsAsTheToolMovingTheOtherWay) {
    const Pose tool = turned(0.4, {1, 2, 3}, {5, 6, 7});
    const Pose organ_before = turned(0, Vec3::UnitX(), {0, 0, 0}),
               organ_after = turned(0, Vec3::UnitX(), {0, 3, 0});
    const ToolMotion motion(tool.seen_from(organ_before), tool.seen_from(organ_after));
    EXPECT_TRUE(motion.direction_at({1, 1, 1}, negligible)->isApprox(Vec3(0, -1, 0), 1e-12));
}

TEST(ToolMotion, WhereBothMoveTheTwoAdd) {
    const Pose tool_before = turned(0, Vec3::UnitX(), {0, 0, 9}),
               tool_after = turned(0, Vec3::UnitX(), {2, 0, 9});
    const Pose organ_before = turned(0, Vec3::UnitX(), {0, 0, 0}),
               organ_after = turned(0, Vec3::UnitX(), {0, 0, 1});
    const ToolMotion motion(tool_before.seen_from(organ_before), tool_after.seen_from(organ_after));
    EXPECT_TRUE(motion.displacement_at({1, 1, 1}).isApprox(Vec3(2, 0, -1), 1e-12));
}

}  // namespace
}  // namespace trocar
