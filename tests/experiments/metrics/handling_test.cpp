// Metrics of how handling moves vertices relative to the tool: gap, drag.

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "square.h"

namespace trocar {
namespace {

const Square square;

TEST(Gap, IsTheDistanceOfMovedVerticesToTheTool) {
    // The tool's flat end is at z = −20: 1 mm and 4 mm below it.
    const Judged step = square.put({-0.5, 0, -21}, {0.5, 0, -24});
    EXPECT_NEAR(value("gap_mean", Moment::handled, step), 2.5, 1e-12);
    EXPECT_NEAR(value("gap_max", Moment::handled, step), 4, 1e-12);
}

TEST(Gap, LeavesOutVerticesThatStayedAndThoseLeftInside) {
    std::vector<Vec3> before = square.steps().rest();
    before[2].z() = -30;  // outside and not moved
    std::vector<Vec3> handled = before;
    handled[0].z() = -21;
    handled[1].z() = -1;  // moved, still inside
    const Judged step = square.steps().step(tip_at(-20), before, handled, handled);
    EXPECT_NEAR(value("gap_mean", Moment::handled, step), 1, 1e-12);
    EXPECT_NEAR(value("gap_max", Moment::handled, step), 1, 1e-12);
}

TEST(Gap, AfterDeformationIsOfTheSameVertices) {
    const JudgedSteps& steps = square.steps();
    std::vector<Vec3> handled = steps.rest(), deformed;
    handled[0].z() = handled[1].z() = -21;
    deformed = handled;
    deformed[0].z() = -23;
    deformed[1].z() = -19;  // back inside
    deformed[2].z() = -30;  // moved by the deformation only
    const Judged step = steps.step(tip_at(-20), steps.rest(), handled, deformed);
    EXPECT_NEAR(value("gap_mean", Moment::deformed, step), 3, 1e-12);
    EXPECT_NEAR(value("gap_max", Moment::deformed, step), 3, 1e-12);
}

TEST(Gap, IsMissingWhereNothingWasPutOutside) {
    const Judged still = square.handled(square.steps().rest());
    EXPECT_EQ(why_missing("gap_mean", Moment::handled, still), Missing::no_vertex_moved);
    const Judged inside = square.put({-0.5, 0, 1}, {0.5, 0, 1});
    EXPECT_EQ(why_missing("gap_max", Moment::handled, inside), Missing::no_vertex_moved);
}

/// The tool came along `motion`; vertices a and b were handled as told, the others stayed.
Judged came_along(const Vec3& motion, const Vec3& a_moves, const Vec3& b_moves) {
    const std::vector<Vec3>& rest = square.steps().rest();
    Judged step = square.put(rest[0] + a_moves, rest[1] + b_moves);
    step.tool_at_beginning.position -= motion;
    return step;
}

TEST(Drag, IsHowFarVerticesGoAlongWithTheTool) {
    // The square's normal is z; of four vertices two move, by 2 and by −1 along the tool's way.
    const Judged step = came_along({1, 0, -5}, {2, 7, 7}, {-1, 0, 0});
    EXPECT_NEAR(value("drag", Moment::handled, step), 2.0 / 4, 1e-14) << "against the tool counts as none";
    EXPECT_NEAR(value("drag", Moment::handled, came_along({0, -1, 0}, {0, -3, 0}, {0, -1, 0})), 1, 1e-14);
}

TEST(Drag, IsMissingWhereTheToolMovesAlongTheNormal) {
    const auto tilted = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return came_along(3 * Vec3(std::sin(angle), 0, -std::cos(angle)), {1, 0, 0}, {0, 0, 0});
    };
    EXPECT_EQ(why_missing("drag", Moment::handled, tilted(0)), Missing::motion_along_normal);
    EXPECT_EQ(why_missing("drag", Moment::handled, tilted(0.9)), Missing::motion_along_normal);
    EXPECT_EQ(why_missing("drag", Moment::handled, tilted(179.1)), Missing::motion_along_normal);
    EXPECT_NEAR(value("drag", Moment::handled, tilted(1.1)), 0.25, 1e-12);
    EXPECT_NEAR(value("drag", Moment::handled, tilted(178.9)), 0.25, 1e-12);
    EXPECT_EQ(why_missing("drag", Moment::handled, came_along({0, 0, 0}, {1, 0, 0}, {0, 0, 0})),
              Missing::motion_along_normal);
}

TEST(Drag, IsMissingWithoutCollidedVertices) {
    const JudgedSteps& steps = square.steps();
    EXPECT_EQ(
        why_missing("drag", Moment::handled, steps.step(tip_at(5), steps.rest(), steps.rest(), steps.rest())),
        Missing::no_vertex_collided);
}

TEST(Drag, FollowsATurningToolAtEachVertex) {
    // A quarter of a degree about z through the origin: at (−0.5, 0) the material came along −y, at (0.5, 0)
    // along +y; the other two vertices move with it as well.
    const double angle = 0.25 * std::numbers::pi / 180;
    Judged step = square.put({-0.5, -2, 0}, {0.5, 4, 0});
    step.tool_at_beginning.rotation = Eigen::AngleAxisd(-angle, Vec3::UnitZ()).toRotationMatrix();
    EXPECT_NEAR(value("drag", Moment::handled, step), (2 + 4) / 4.0, 1e-4);
}

TEST(Drag, LooksAlongTheNormalAtRest) {
    // On a sphere whose rest normals differ from vertex to vertex: only vertices off the pole have sideways
    // motion, and what they are moved outwards is no drag.
    const JudgedSteps sphere(make_organ_by_formula("sphere@3mm"), make_prism(12));
    const Vec3 top(0, 0, bounding_box(sphere.rest()).high.z());
    const Pose pose{.rotation = Mat3::Identity(), .position = top - Vec3(0, 0, 3)};
    std::vector<Vec3> out = sphere.rest();
    const JudgedState before = sphere.state(sphere.rest(), pose);
    ASSERT_FALSE(before.inside().empty());
    for (const Index vertex : before.inside())
        out[vertex] += 2 * sphere.judged_organ().vertex_normals()[vertex];
    Judged step = sphere.step(pose, sphere.rest(), out, out);
    step.tool_at_beginning.position += Vec3(0, 0, 3);
    EXPECT_NEAR(value("drag", Moment::handled, step), 0, 1e-12);
}

}  // namespace
}  // namespace trocar
