// e(x, d): the first place along d that is outside at a distance of at least the clearance.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/general_solid.h"
#include "common/geometry/solid.h"
#include "common/tool/tool_shapes.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

constexpr double clearance = 0.01;

/// Distance to the surface by CGAL's tree, negative inside.
double signed_distance(const SurfaceQueries& surface, const Vec3& point) {
    const double distance = surface.distance(point);
    return surface.contains(point) ? -distance : distance;
}

/// A slow oracle: steps that can never pass over a place at the clearance, since a distance changes by no
/// more than the way gone.
double marched(const SurfaceQueries& surface, const Vec3& point, const Vec3& direction) {
    double t = 0;
    for (int step = 0; step < 100'000; ++step) {
        const double missing = clearance - signed_distance(surface, point + t * direction);
        if (missing < 1e-11) break;
        t += missing;
    }
    return t;
}

/// A square tool, 8 mm wide (corners on a circle of radius 4 √2), 10 mm long, turned by 45 degrees.
Tool square_tool() { return make_prism(4, 4 * std::numbers::sqrt2, 10); }

TEST(ExitDistance, LeadsToTheFaceMovedOutByTheClearance) {
    const Solid solid = square_tool().solid;
    const Vec3 inside(0, 0, 2), side = Vec3(1, 1, 0).normalized();
    EXPECT_DOUBLE_EQ(solid.exit_distance(inside, -Vec3::UnitZ(), clearance), 2.01);
    EXPECT_DOUBLE_EQ(solid.exit_distance(inside, Vec3::UnitZ(), clearance), 8.01);
    EXPECT_NEAR(solid.exit_distance(inside, side, clearance), 4.01, 1e-12);
}

TEST(ExitDistance, AtAnEdgeIsTheClearanceFromTheEdge) {
    const Solid solid = square_tool().solid;
    EXPECT_NEAR(solid.exit_distance({0, 0, 2}, Vec3::UnitX(), clearance), 4 * std::numbers::sqrt2 + clearance,
                1e-12);
}

TEST(ExitDistance, AtATipIsTheClearanceFromTheTip) {
    const Solid needle = make_needle().solid;
    EXPECT_NEAR(needle.exit_distance({0, 0, 3}, -Vec3::UnitZ(), clearance), 3 + clearance, 1e-12);
}

TEST(ExitDistance, FromOutsideNearerThanTheClearanceIsWhatIsMissing) {
    const Solid solid = square_tool().solid;
    EXPECT_NEAR(solid.exit_distance({0, 0, -0.004}, -Vec3::UnitZ(), clearance), 0.006, 1e-12);
    EXPECT_NEAR(solid.exit_distance({0, 0, -0.004}, Vec3::UnitZ(), clearance), 10.014, 1e-12) << "through it";
    EXPECT_EQ(solid.exit_distance({0, 0, -0.02}, Vec3::UnitZ(), clearance), 0) << "it is out already";
}

TEST(ExitDistance, StopsInTheGapBetweenTheJawsIfTheGapIsWideEnough) {
    const Tool tool = make_grasper();
    const double angle = 20 * std::numbers::pi / 180, crotch = 18 * std::cos(angle);
    const double height = 6, gap = (crotch - height) * std::tan(angle);  // from the axis to an inner face
    const Vec3 in_jaw(0, gap + 0.5, height);
    ASSERT_TRUE(tool.solid.contains(in_jaw));
    const double to_gap = 0.5 + clearance / std::cos(angle);
    EXPECT_NEAR(tool.solid.exit_distance(in_jaw, -Vec3::UnitY(), clearance), to_gap, 1e-5);

    const double wide = 2 * gap * std::cos(angle);  // more than there is room for
    EXPECT_GT(tool.solid.exit_distance(in_jaw, -Vec3::UnitY(), wide), 2 * gap + 0.5)
        << "through the other jaw";
}

class ConvexTool : public testing::TestWithParam<const char*> {};

TEST_P(ConvexTool, GivesTheSameExitAsAGeneralOne) {
    const Tool tool = make_tool_by_formula(GetParam());
    const SolidMesh mesh(tool.mesh);
    const ConvexSolid fast(mesh);
    const GeneralSolid general(mesh);
    int through_faces = 0;
    const bool passed = rc::check([&] {
        for (int k = 0; k < 50; ++k) {
            // Half of the points near the tip, where there are edges all around.
            const double low = random_number(0, 1) < 0.5 ? 0 : 0.9;
            Box box = mesh.box;
            box.low.z() += low * box.size().z();
            box.high.z() -= (low == 0 ? 0.8 : 0) * box.size().z();
            const Vec3 point = random_point(box), direction = random_direction();
            if (!fast.contains(point)) continue;
            const auto exit = fast.exit_through_face(point, direction, clearance);
            const double expected = general.exit_distance(point, direction, clearance);
            RC_ASSERT(tool.solid.exit_distance(point, direction, clearance) == exit.value_or(expected));
            if (!exit) continue;
            ++through_faces;
            RC_ASSERT(std::abs(*exit - expected) < 1e-9);
        }
    });
    EXPECT_TRUE(passed);
    EXPECT_GT(through_faces, 100);
}

TEST_P(ConvexTool, ExitIsOutsideAtExactlyTheClearance) {
    const Tool tool = make_tool_by_formula(GetParam());
    const SurfaceQueries surface(tool.mesh);
    EXPECT_TRUE(rc::check([&] {
        Box box = tool.solid.box();
        box.high.z() = 20;
        const Vec3 point = random_point(box), direction = random_direction();
        RC_PRE(surface.contains(point));
        const double exit = tool.solid.exit_distance(point, direction, clearance);
        RC_ASSERT(std::abs(signed_distance(surface, point + exit * direction) - clearance) < 1e-11);
        const double before = exit * random_number(0, 0.999999);
        RC_ASSERT(signed_distance(surface, point + before * direction) < clearance);
    }));
}
INSTANTIATE_TEST_SUITE_P(ByFormula, ConvexTool,
                         testing::Values("prism-3", "prism-12", "pointed-prism-3", "pointed-prism-12",
                                         "needle"),
                         [](const auto& tool) {
                             std::string name = tool.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(ExitDistance, OfAGrasperIsWhatMarchingFinds) {
    const Tool tool = make_grasper();
    const SurfaceQueries surface(tool.mesh);
    EXPECT_TRUE(rc::check([&] {
        for (int k = 0; k < 20; ++k) {
            const Vec3 point = random_point(Box{{-2.5, -8, 0}, {2.5, 8, 20}}), direction = random_direction();
            const double exit = tool.solid.exit_distance(point, direction, clearance);
            RC_ASSERT(signed_distance(surface, point + exit * direction) > clearance - 1e-11);
            RC_ASSERT(std::abs(exit - marched(surface, point, direction)) < 1e-7);
        }
    }));
}

}  // namespace
}  // namespace trocar
