#include "common/tool/recorded_motion.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trocar {
namespace {

using testing::HasSubstr;

const std::string header = "t,x,y,z,qw,qx,qy,qz\n";

TEST(RecordedMotion, IsReadWithCommentsSpacesAndWindowsLineEnds) {
    const RecordedMotion motion = parse_recorded_motion(
        "# made by hand\r\n t , x,y,z,qw,qx,qy,qz\r\n\r\n0.5, 1,2,3, 1,0,0,0\r\n1.5,1,2,-1e1,0,0,0,-1");
    EXPECT_EQ(motion.times, (std::vector<double>{0.5, 1.5}));
    EXPECT_EQ(motion.poses[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(motion.poses[1].position, Vec3(1, 2, -10));
    EXPECT_TRUE(motion.poses[1].rotation.isApprox(Vec3(-1, -1, 1).asDiagonal().toDenseMatrix()));
    EXPECT_EQ(motion.duration(), 1);
}

TEST(RecordedMotion, GoesStraightAndTurnsTheShortWayBetweenPoses) {
    // A quarter turn about z, written once with each sign of the quaternion.
    const double h = std::sqrt(0.5);
    const RecordedMotion motion = parse_recorded_motion(
        header + "0,0,0,0,1,0,0,0\n2,4,0,0,-" + std::to_string(h) + ",0,0,-" + std::to_string(h) + "\n");
    const Pose half = motion.at(1);
    EXPECT_TRUE(half.position.isApprox(Vec3(2, 0, 0)));
    const Mat3 eighth = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()).toRotationMatrix();
    EXPECT_TRUE(half.rotation.isApprox(eighth, 1e-5));
    EXPECT_EQ(motion.at(-1).position, motion.poses.front().position);
    EXPECT_EQ(motion.at(2).position, motion.poses.back().position);
    EXPECT_EQ(motion.at(99).position, motion.poses.back().position);
}

TEST(RecordedMotion, ItsSpeedIsTheTipsRootMeanSquareOverTime) {
    // 3 mm/s for one second, 1 mm/s for three.
    const RecordedMotion motion =
        parse_recorded_motion(header + "0,0,0,0,1,0,0,0\n1,3,0,0,1,0,0,0\n4,3,3,0,1,0,0,0\n");
    EXPECT_NEAR(motion.tip_speed(), std::sqrt((9.0 * 1 + 1.0 * 3) / 4), 1e-12);
}

struct Mistake {
    std::string text, where, what;
};
class RefusedMotion : public testing::TestWithParam<Mistake> {};

TEST_P(RefusedMotion, SaysWhereAndWhat) {
    try {
        (void)parse_recorded_motion(GetParam().text);
        FAIL() << "no error";
    } catch (const MotionError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(GetParam().where + ": "));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().what));
    }
}
const std::string pose = "0,0,0,0,1,0,0,0\n";
INSTANTIATE_TEST_SUITE_P(
    Motions, RefusedMotion,
    testing::Values(Mistake{"", "1:1", "empty"},
                    Mistake{"t,x,y,z,qx,qy,qz,qw\n", "1:9", "expected the column name qw, found \"qx\""},
                    Mistake{header, "1:1", "at least two poses"}, Mistake{header + pose, "2:1", "two poses"},
                    Mistake{header + pose + "1,0,0\n", "3:6", "3 values; expected 8"},
                    Mistake{header + pose + "1,0,0,0,1,0,0,0,7\n", "3:17", "more than 8"},
                    Mistake{header + pose + "1,0,zero,0,1,0,0,0\n", "3:5", "y must be a finite number"},
                    Mistake{header + pose + "1,0,nan,0,1,0,0,0\n", "3:5", "finite"},
                    Mistake{header + pose + "1,0,,0,1,0,0,0\n", "3:5", "found \"\""},
                    Mistake{header + pose + "1,0,0,0,2,0,0,0\n", "3:1", "length 2"},
                    Mistake{header + pose + pose, "3:1", "must ascend"}));

}  // namespace
}  // namespace trocar
