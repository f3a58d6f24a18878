#include "common/tool/pivot.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace trocar {
namespace {

Pose incision() {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    pose.position = {10, -20, 30};
    return pose;
}

TEST(Pivoted, TheAxisAlwaysPassesThroughTheIncision) {
    for (const double angle : {-0.6, 0.0, 0.3}) {
        const Pose pose =
            pivoted(incision(), {.yaw = angle, .pitch = 0.2, .roll = 2 * angle, .insertion = 70});
        const Vec3 axis = pose.rotation.col(2);
        EXPECT_TRUE((pose.position + 70 * axis).isApprox(incision().position, 1e-12));
        EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
    }
}

TEST(Pivoted, WithoutYawAndPitchItPointsStraightIn) {
    const Pose pose = pivoted(incision(), {.insertion = 5});
    EXPECT_TRUE(pose.rotation.isApprox(incision().rotation, 1e-15));
    EXPECT_TRUE(pose.position.isApprox(incision().to_world({0, 0, -5}), 1e-12));
}

TEST(Pivoted, RollLeavesTheTipWhereItIs) {
    const PivotState state{.yaw = 0.1, .pitch = -0.2, .roll = 0, .insertion = 90};
    PivotState rolled = state;
    rolled.roll = 1.3;
    EXPECT_TRUE(pivoted(incision(), state).position.isApprox(pivoted(incision(), rolled).position, 1e-12));
}

}  // namespace
}  // namespace trocar
