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

}  // namespace
}  // namespace trocar
