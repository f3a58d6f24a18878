#include "common/tool/tool_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/adjacency.h"
#include "common/geometry/predicates.h"
#include "common/geometry/surface_queries.h"

namespace trocar {
namespace {

class Prism : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sides, Prism, testing::Values(3, 4, 6, 12, 64));

TEST_P(Prism, IsAClosedSolidOfTheRightSize) {
    const int sides = GetParam();
    const Tool tool = make_tool_by_formula("prism-" + std::to_string(sides));
    EXPECT_EQ(tool.name, "prism-" + std::to_string(sides));
    EXPECT_TRUE(Adjacency(tool.mesh.positions.size(), tool.mesh.facets).closed());
    const double angle = 2 * M_PI / sides;
    EXPECT_NEAR(signed_volume(tool.mesh), 80 * sides * 16 * std::sin(angle) / 2, 1e-9);
    for (const Vec3& position : tool.mesh.positions) {
        EXPECT_NEAR(std::hypot(position.x(), position.y()), 4, 1e-14);
        EXPECT_TRUE(position.z() == 0 || position.z() == 80);
    }
}

TEST_P(Prism, HasExactlyFlatSidesAndEnds) {
    const Tool tool = make_prism(GetParam());
    const auto is_flat = [&](const Facet& f, Index vertex) {
        const std::vector<Vec3>& p = tool.mesh.positions;
        return orientation_sign(p[f[0]], p[f[1]], p[f[2]], p[vertex]) == 0;
    };
    const Index sides = GetParam();
    for (Index side = 0; side < sides; ++side) {
        const Index lower = 2 * side, upper = lower + 1;  // the two facets of this side
        EXPECT_TRUE(is_flat(tool.mesh.facets[lower], tool.mesh.facets[upper][2]));
    }
    EXPECT_EQ(tool.solid.face_count(), static_cast<std::size_t>(sides) + 2);
}

TEST(Prism, OfOtherSizesHasThemInItsName) {
    EXPECT_EQ(make_prism(6, 5, 80).name, "prism-6 r5 l80");
    EXPECT_EQ(make_prism(6, 4, 40.5).name, "prism-6 r4 l40.5");
    EXPECT_EQ(make_prism(6, 4, 80).name, "prism-6");
}

TEST(Prism, RefusesWhatIsNoPrism) {
    EXPECT_THROW(make_prism(2), std::invalid_argument);
    EXPECT_THROW(make_prism(65), std::invalid_argument);
    EXPECT_THROW(make_prism(6, 0), std::invalid_argument);
    EXPECT_THROW(make_prism(6, 4, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(ToolByFormula, SaysWhatWasExpected) {
    const auto message_of = [](const std::string& formula) -> std::string {
        try {
            make_tool_by_formula(formula);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    EXPECT_THAT(message_of("prsm-12"),
                testing::StartsWith("unknown tool \"prsm-12\"; did you mean \"prism-N\"? Known: prism-N, "));
    for (const std::string wrong : {"prism-", "prism-2", "prism-65", "prism-6x", "prism-6.5", "prism--6"}) {
        EXPECT_EQ(
            message_of(wrong),
            "tool \"" + wrong + "\": expected prism-N, N a whole number from 3 to 64, such as prism-12");
    }
    EXPECT_EQ(message_of("pointed-prism-2"),
              "tool \"pointed-prism-2\": expected pointed-prism-N, N a whole number from 3 to 64, such as "
              "pointed-prism-12");
    EXPECT_THAT(message_of("needle-3"), testing::HasSubstr("unknown tool \"needle-3\""));
}

// Area of a regular polygon with its corners on a circle.
double polygon_area(int sides, double radius) {
    return sides * radius * radius * std::sin(2 * std::numbers::pi / sides) / 2;
}

/// A formula of every shape of the list; of 12 sides where it states a number.
std::vector<std::string> every_formula() {
    std::vector<std::string> all;
    for (const ToolShape& shape : all_tool_shapes()) {
        const bool numbered = shape.name.ends_with('N');
        all.push_back(numbered ? shape.name.substr(0, shape.name.size() - 1) + "12" : shape.name);
    }
    return all;
}

class EveryTool : public testing::TestWithParam<std::string> {
  protected:
    const Tool tool_ = make_tool_by_formula(GetParam());
};
INSTANTIATE_TEST_SUITE_P(ByFormula, EveryTool, testing::ValuesIn(every_formula()), [](const auto& tested) {
    std::string name = tested.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST_P(EveryTool, IsAClosedSolidWithItsTipAtTheOrigin) {
    EXPECT_EQ(tool_.name, GetParam());
    EXPECT_TRUE(Adjacency(tool_.mesh.positions.size(), tool_.mesh.facets).closed());
    EXPECT_GT(signed_volume(tool_.mesh), 0);
    EXPECT_EQ(tool_.solid.box().low.z(), 0);
    EXPECT_EQ(tool_.solid.box().high.z(), 80);
    EXPECT_NEAR(tool_.solid.box().centre().head<2>().norm(), 0, 1e-12) << "the axis is the middle";
}

TEST_P(EveryTool, AnswersInsideAndOutside) {
    const SurfaceQueries surface(tool_.mesh);
    const Box& box = tool_.solid.box();
    constexpr double clearance = 0.01;
    int inside = 0;
    for (int k = 1; k <= 2000; ++k) {
        // Multiples of irrational numbers fill the box evenly, on no plane of the tool.
        Vec3 fraction = k * Vec3(0.8191725134, 0.6710436067, 0.5497004779);
        for (double& number : fraction) number -= std::floor(number);
        const Vec3 point = box.low + box.size().cwiseProduct(fraction);
        ASSERT_EQ(tool_.solid.contains(point), surface.contains(point)) << point.transpose();
        ASSERT_EQ(tool_.solid.nearest_face(point).signed_distance < 0, surface.contains(point))
            << point.transpose();
        if (!surface.contains(point)) continue;
        ++inside;
        const Vec3 direction = Vec3(std::sin(k), std::cos(2 * k), std::sin(3 * k + 1)).normalized();
        const Vec3 exit = point + tool_.solid.exit_distance(point, direction, clearance) * direction;
        ASSERT_FALSE(surface.contains(exit)) << point.transpose();
        ASSERT_NEAR(surface.distance(exit), clearance, 1e-9) << point.transpose();
    }
    EXPECT_GT(inside, 100);
}

class PointedPrism : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sides, PointedPrism, testing::Values(3, 4, 12, 64));

TEST_P(PointedPrism, IsAPyramidOnAPrism) {
    const int sides = GetParam();
    const Tool tool = make_pointed_prism(sides);
    EXPECT_TRUE(tool.solid.convex());
    EXPECT_EQ(tool.solid.face_count(), 2 * static_cast<std::size_t>(sides) + 1);
    EXPECT_NEAR(signed_volume(tool.mesh), polygon_area(sides, 4) * (72 + 8.0 / 3), 1e-9);
    EXPECT_NEAR(tool.radius, 4, 1e-14);
    EXPECT_EQ(tool.solid.support(-Vec3::UnitZ()), Vec3(0, 0, 0));
}

TEST(PointedPrism, HasOtherSizesInItsNameAndRefusesImpossibleOnes) {
    EXPECT_EQ(make_pointed_prism(6, {.tip_length = 12.5}).name, "pointed-prism-6 r4 l80 t12.5");
    EXPECT_THROW(make_pointed_prism(2), std::invalid_argument);
    EXPECT_THROW(make_pointed_prism(6, {.radius = -1}), std::invalid_argument);
    EXPECT_THROW(make_pointed_prism(6, {.tip_length = 0}), std::invalid_argument);
    EXPECT_THROW(make_pointed_prism(6, {.length = 8, .tip_length = 8}), std::invalid_argument);
}

TEST(Needle, HasATipOfItsAngle) {
    const Tool tool = make_needle();
    EXPECT_TRUE(tool.solid.convex());
    EXPECT_NEAR(tool.radius, 0.75, 1e-14);
    const double tip = 0.75 / std::tan(2.5 * std::numbers::pi / 180);
    EXPECT_NEAR(signed_volume(tool.mesh), polygon_area(16, 0.75) * (80 - 2 * tip / 3), 1e-9);
    // Opposite edges of the tip: the corners of the ring after it.
    const Vec3 one = tool.mesh.positions[1], other = tool.mesh.positions[9];
    EXPECT_NEAR(std::acos(one.normalized().dot(other.normalized())), 5 * std::numbers::pi / 180, 1e-12);
}

TEST(Needle, HasOtherSizesInItsNameAndRefusesImpossibleOnes) {
    EXPECT_EQ(make_needle({.radius = 1}).name, "needle r1 l80 a5");
    EXPECT_THROW(make_needle({.radius = 0}), std::invalid_argument);
    EXPECT_THROW(make_needle({.tip_angle = 0.5}), std::invalid_argument);
    EXPECT_THROW(make_needle({.tip_angle = 121}), std::invalid_argument);
    EXPECT_THROW(make_needle({.radius = 4}), std::invalid_argument) << "its tip would be 92 mm long";
}

TEST(Grasper, HasTwoOpenTaperingJawsOnAnOctagonalShaft) {
    const Tool tool = make_grasper();
    const Solid& solid = tool.solid;
    EXPECT_FALSE(solid.convex());
    EXPECT_EQ(solid.face_count(), 8U + 1 + 2 * (4 + 1 + 1)) << "every side is exactly flat";
    const double angle = 20 * std::numbers::pi / 180, jaw = 18 * std::cos(angle);
    // Each jaw is a frustum: from half an octagon to half of one of half the size.
    EXPECT_NEAR(signed_volume(tool.mesh), polygon_area(8, 2.5) * (80 - jaw + jaw * (1 + 0.25 + 0.5) / 3),
                1e-3);
    EXPECT_NEAR(tool.radius, 18 * std::sin(angle) + 1.25, 1e-5);

    const NearestFace inner = solid.nearest_face({0, 3, 8});
    EXPECT_TRUE(inner.normal.isApprox(Vec3(0, -std::cos(angle), -std::sin(angle)), 1e-6));
    for (const double side : {1.0, -1.0}) {
        EXPECT_TRUE(solid.contains({0, side * (18 * std::sin(angle) + 0.6), 0.01})) << "the tip of a jaw";
        EXPECT_TRUE(solid.contains({0, side * 0.1, jaw - 0.01})) << "beside the crotch";
    }
    EXPECT_FALSE(solid.contains({0, 0, jaw - 0.01})) << "between the jaws";
    EXPECT_TRUE(solid.contains({0, 0, jaw + 0.01})) << "in the shaft";
}

TEST(Grasper, IsSoundAtTheEndsOfItsRanges) {
    for (const double opening : {1.0, 60.0}) {
        for (const double jaw_length : {1.0, 60.0}) {
            const Tool tool = make_grasper({.jaw_length = jaw_length, .opening = opening});
            EXPECT_EQ(tool.solid.face_count(), 21U) << tool.name;
            EXPECT_FALSE(tool.solid.convex()) << tool.name;
        }
    }
}

TEST(Grasper, HasOtherSizesInItsNameAndRefusesImpossibleOnes) {
    EXPECT_EQ(make_grasper({.opening = 30}).name, "grasper r2.5 l80 j18 o30");
    EXPECT_THROW(make_grasper({.radius = 0}), std::invalid_argument);
    EXPECT_THROW(make_grasper({.opening = 0}), std::invalid_argument);
    EXPECT_THROW(make_grasper({.opening = 61}), std::invalid_argument);
    EXPECT_THROW(make_grasper({.length = 16}), std::invalid_argument) << "the jaws alone are 16.9 mm";
}

}  // namespace
}  // namespace trocar
