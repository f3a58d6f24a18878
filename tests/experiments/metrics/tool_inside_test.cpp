// tool_volume_inside and tool_points_inside where the answer is known.

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "box_organ.h"
#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "judged_steps.h"

namespace trocar {
namespace {

struct Inside {
    double volume;  // mm³
    double points;
};

Inside inside(const JudgedSteps& scene, const Pose& pose, const JudgedSteps::Positions& positions) {
    const Judged step = scene.step(pose, positions, positions, positions);
    return {.volume = value("tool_volume_inside", Moment::handled, step),
            .points = value("tool_points_inside", Moment::handled, step)};
}

Inside inside(const JudgedSteps& scene, const Pose& pose) { return inside(scene, pose, scene.rest()); }

/// One surface of two parts.
SurfaceMesh both(SurfaceMesh one, const SurfaceMesh& other) {
    const auto first = static_cast<Index>(one.positions.size());
    one.positions.insert(one.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.facets) one.facets.push_back({a + first, b + first, c + first});
    return one;
}

/// Cross-section of a prism, mm².
double prism_area(int sides, double radius) {
    return sides * radius * radius * std::sin(2 * std::numbers::pi / sides) / 2;
}

class ToolInBox : public testing::TestWithParam<int> {};  // by the box's resolution

TEST_P(ToolInBox, OverlappingBy1500Micrometres) {
    const JudgedSteps boxes(box_organ({-20, -20, -40}, {20, 20, 0}, GetParam()), make_prism(4, 11.3, 60));
    const double area = prism_area(4, 11.3), girth = 4 * std::sqrt(area);
    for (const double depth : {0.01, 1.5}) {
        const Inside overlapping = inside(boxes, tip_at(-depth));
        EXPECT_NEAR(overlapping.volume, depth * area, 1e-9);
        EXPECT_NEAR(overlapping.points, area + depth * girth, 6);
    }
    for (const double gap : {0.0, 1e-9, 1.5}) {
        const Inside apart = inside(boxes, tip_at(gap));
        EXPECT_EQ(apart.volume, 0) << gap;
        EXPECT_EQ(apart.points, 0) << gap;
    }
    // Beside the box, and under it with the handle's end.
    EXPECT_EQ(inside(boxes, {.rotation = Mat3::Identity(), .position = {31.4, 0, -30}}).volume, 0);
    EXPECT_EQ(inside(boxes, {.rotation = Mat3::Identity(), .position = {31.4, 0, -30}}).points, 0);
    EXPECT_EQ(inside(boxes, tip_at(-101.5)).volume, 0);
    EXPECT_EQ(inside(boxes, tip_at(-101.5)).points, 0);
    EXPECT_NEAR(inside(boxes, tip_at(-98.5)).volume, 1.5 * area, 1e-9);
}

TEST_P(ToolInBox, LyingOnItsSideAndHardlyInside) {
    // The prism's side is 0.05 mm deep and 60 mm long: what few rays along it would see.
    const JudgedSteps boxes(box_organ({-50, -50, -40}, {50, 50, 0}, GetParam()), make_prism(4, 11.3, 60));
    const double half_side = 11.3 / std::numbers::sqrt2;
    const Mat3 lying = (Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()) *
                        Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()))
                           .toRotationMatrix();
    const Inside found = inside(boxes, {.rotation = lying, .position = {0, 30, half_side - 0.05}});
    EXPECT_NEAR(found.volume, 0.05 * 60 * 2 * half_side, 1e-9);
    EXPECT_NEAR(found.points, 60 * 2 * half_side + 0.1 * (60 + 2 * half_side), 8);
}

TEST_P(ToolInBox, SwallowedWhole) {
    for (const char* name : {"prism-12", "pointed-prism-5", "needle", "grasper"}) {
        const JudgedSteps scene(box_organ({-50, -50, -50}, {50, 50, 50}, GetParam()),
                                make_tool_by_formula(name));
        const Inside found = inside(scene, tip_at(-41));
        const double volume = signed_volume(scene.tool().mesh);
        EXPECT_NEAR(found.volume, volume, 1e-9 * volume) << name;
        EXPECT_EQ(found.points, scene.judged_tool().points().size()) << name;
        const JudgedState state = scene.state(scene.rest(), tip_at(-41));
        EXPECT_TRUE(state.crossing_facets().empty()) << "nothing crosses";
    }
}

TEST_P(ToolInBox, ThinnerThanAFacet) {
    const JudgedSteps scene(box_organ({-31, -29, -20}, {27, 33, -15}, GetParam()), make_needle());
    const Inside found = inside(scene, tip_at(-50));
    const JudgedState state = scene.state(scene.rest(), tip_at(-50));
    EXPECT_TRUE(state.inside().empty()) << "no vertex tells of it";
    EXPECT_NEAR(found.volume, 5 * prism_area(16, 0.75), 1e-9);
    EXPECT_NEAR(found.points, 5 * 2 * std::numbers::pi * 0.75, 4);
}

TEST_P(ToolInBox, CountsAPartOfWindingTwoOnce) {
    // Two boxes, of which the second begins 1.3 mm beside the tool's axis: there they overlap 20 mm deep.
    const SurfaceMesh one = box_organ({-20, -20, -40}, {20, 20, 0}, GetParam()).rest;
    const SurfaceMesh other = box_organ({1.3, -20, -20}, {20, 20, 10}, GetParam()).rest;
    const JudgedSteps scene(make_organ("boxes", both(one, other)), make_prism(4));
    const double beside = (4 - 1.3) * (4 - 1.3);  // mm² of the cross-section
    const double girth = 16 * std::numbers::sqrt2, girth_beside = 2 * (4 - 1.3) * std::numbers::sqrt2;
    for (const double depth : {10, 30}) {  // of the tip, which is in both boxes, or in the first one
        const Inside found = inside(scene, tip_at(-depth));
        const double volume = depth * prism_area(4, 4) + 10 * beside;
        EXPECT_NEAR(found.volume, volume, 0.01 * volume);
        EXPECT_NEAR(found.points, prism_area(4, 4) + depth * girth + 10 * girth_beside, 8);
    }
}

TEST_P(ToolInBox, SwallowedTwiceIsSwallowedOnce) {
    const SurfaceMesh one = box_organ({-50, -50, -50}, {50, 50, 50}, GetParam()).rest;
    const SurfaceMesh other = box_organ({-30, -30, -45}, {30, 30, 45}, GetParam()).rest;
    for (const char* name : {"prism-12", "grasper"}) {
        const JudgedSteps scene(make_organ("boxes", both(one, other)), make_tool_by_formula(name));
        const Inside found = inside(scene, tip_at(-41));
        const double volume = signed_volume(scene.tool().mesh);
        EXPECT_NEAR(found.volume, volume, 0.005 * volume) << name;
        EXPECT_EQ(found.points, scene.judged_tool().points().size()) << name;
    }
}

TEST_P(ToolInBox, AnInvertedPocketIsNotInside) {
    // Turned inside out the box has nothing inside; with a sound box in the tool's way, that alone counts.
    SurfaceMesh inverted = box_organ({-20, -20, -40}, {20, 20, 0}, GetParam()).rest;
    for (Vec3& p : inverted.positions) p.x() = -p.x();
    const JudgedSteps alone(make_organ("pocket", inverted), make_prism(12));
    EXPECT_EQ(inside(alone, tip_at(-30)).volume, 0);
    EXPECT_EQ(inside(alone, tip_at(-30)).points, 0);

    const SurfaceMesh sound = box_organ({-20, -20, 1}, {20, 20, 2}, GetParam()).rest;
    const JudgedSteps with_sound(make_organ("both", both(inverted, sound)), make_prism(12));
    EXPECT_NEAR(inside(with_sound, tip_at(-30)).volume, prism_area(12, 4), 0.01 * prism_area(12, 4));
    EXPECT_NEAR(inside(with_sound, tip_at(-0.5)).volume, prism_area(12, 4), 0.01 * prism_area(12, 4));
    EXPECT_NEAR(inside(with_sound, tip_at(-30)).points, 25, 4);
}
INSTANTIATE_TEST_SUITE_P(Resolutions, ToolInBox, testing::Values(1, 2, 5, 20));

TEST(ToolInside, NothingInAPocketPushedRightThroughABox) {
    // The middle of the box's top is pushed through its bottom, with upright walls: above the bottom the
    // pocket has winding number 0, beneath it −1.
    const JudgedSteps scene(box_organ({-20, -20, -40}, {20, 20, 0}, 10), make_prism(12, 3, 80));
    JudgedSteps::Positions folded = scene.rest();
    for (Vec3& p : folded) {
        const double from_axis = p.head<2>().cwiseAbs().maxCoeff();
        if (p.z() != 0 || from_axis > 13) continue;
        if (from_axis < 9) {
            p.z() = -60;
        } else {
            p.head<2>() *= 2.0 / 3;
        }
    }
    EXPECT_EQ(inside(scene, tip_at(-55), folded).volume, 0);
    EXPECT_EQ(inside(scene, tip_at(-55), folded).points, 0);
    // Aside of the pocket's wall, at x = 8, half of the tool is in the box. The wall holds the tool's axis.
    const Pose at_wall{.rotation = Mat3::Identity(), .position = {8, 0, -30}};
    EXPECT_NEAR(inside(scene, at_wall, folded).volume, 15 * prism_area(12, 3), 1e-6);
    EXPECT_GT(inside(scene, at_wall, folded).points, 0);
}

TEST(ToolInside, ABallSunkIntoASlabOrASheetLeavesACap) {
    constexpr double radius = 6;
    SurfaceMesh ball = make_organ_by_formula("sphere@4mm").rest;
    const double scale = std::cbrt(4.0 / 3 * std::numbers::pi * std::pow(radius, 3) / signed_volume(ball));
    for (Vec3& p : ball.positions) p = scale * p + radius * Vec3::UnitZ();
    const auto check = [&](Organ organ) {
        const JudgedSteps scene(std::move(organ), make_tool("ball", ball));
        for (const double height : {3.0, 5.0, 9.0}) {
            const Inside found = inside(scene, {.rotation = Mat3::Identity(), .position = {1, 2, -height}});
            const double cap = std::numbers::pi * height * height * (3 * radius - height) / 3;
            EXPECT_NEAR(found.volume, cap, 0.005 * cap) << scene.organ().name;
            EXPECT_NEAR(found.points, 2 * std::numbers::pi * radius * height, 8) << scene.organ().name;
        }
        EXPECT_EQ(inside(scene, tip_at(0.1)).volume, 0) << scene.organ().name;
        EXPECT_EQ(inside(scene, tip_at(0.1)).points, 0) << scene.organ().name;
        const Inside whole = inside(scene, tip_at(-14));
        EXPECT_NEAR(whole.volume, signed_volume(ball), 1e-6) << scene.organ().name;
        EXPECT_EQ(whole.points, scene.judged_tool().points().size()) << scene.organ().name;
    };
    for (const int cells : {1, 4, 16}) check(box_organ({-20, -20, -40}, {20, 20, 0}, cells));
    for (const char* sheet : {"sheet@10mm", "sheet@4mm", "sheet@2mm"}) check(make_organ_by_formula(sheet));
}

TEST(ToolInside, BeneathASheetIsInsideHoweverTheToolIsTurned) {
    for (const char* sheet : {"sheet@10mm", "sheet@4mm"}) {
        const JudgedSteps scene(make_organ_by_formula(sheet), make_prism(12));
        const double area = prism_area(12, 4), girth = 24 * 4 * std::sin(std::numbers::pi / 12);
        const auto turned = [](double angle) {
            return Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
        };
        const Inside tip_up = inside(scene, {.rotation = turned(std::numbers::pi), .position = {1, 2, 5}});
        EXPECT_NEAR(tip_up.volume, 75 * area, 1e-6);
        EXPECT_NEAR(tip_up.points, 75 * girth + area, 10);
        for (const double angle : {0.4, 1.5, 2.8}) {
            const Mat3 rotation = turned(angle);
            const Vec3 middle(1, 2, -60);
            const Inside whole =
                inside(scene, {.rotation = rotation, .position = middle - 40 * rotation.col(2)});
            EXPECT_NEAR(whole.volume, 80 * area, 1e-6) << angle;
            EXPECT_EQ(whole.points, scene.judged_tool().points().size()) << angle;
            const Inside above =
                inside(scene, {.rotation = rotation, .position = -middle - 40 * rotation.col(2)});
            EXPECT_EQ(above.volume, 0) << angle;
            EXPECT_EQ(above.points, 0) << angle;
        }
    }
}

TEST(ToolPoints, AreOneForEverySquareMillimetreOfTheSurface) {
    for (const char* name : {"prism-3", "prism-12", "pointed-prism-12", "needle", "grasper"}) {
        const Tool tool = make_tool_by_formula(name);
        const JudgedTool judged(tool);
        const std::vector<double> areas = facet_areas(tool.mesh);
        EXPECT_EQ(judged.points().size(), std::lround(std::accumulate(areas.begin(), areas.end(), 0.0)))
            << name;
        for (const Vec3& point : judged.points()) EXPECT_LT(judged.surface().distance(point), 1e-9) << name;
    }
    SurfaceMesh tiny = make_prism(3).mesh;
    for (Vec3& p : tiny.positions) p *= 1e-3;
    const Tool tool = make_tool("tiny", tiny);
    EXPECT_EQ(JudgedTool(tool).points().size(), 1U);
}

TEST(ToolInside, IsMissingWhereThereIsNoInside) {
    const JudgedSteps scene(make_organ("open", make_organ_by_formula("sheet@10mm").rest), make_prism(12));
    const Judged step = scene.step(tip_at(-5), scene.rest(), scene.rest(), scene.rest());
    for (const Moment moment : {Moment::handled, Moment::deformed}) {
        EXPECT_EQ(why_missing("tool_volume_inside", moment, step), Missing::open_organ);
        EXPECT_EQ(why_missing("tool_points_inside", moment, step), Missing::open_organ);
    }
}

TEST(ToolInside, IsTakenOfTheMomentAskedFor) {
    const JudgedSteps scene(box_organ({-20, -20, -40}, {20, 20, 0}, 3), make_prism(12));
    JudgedSteps::Positions lower = scene.rest();
    for (Vec3& p : lower) p.z() -= 1;
    const Judged step = scene.step(tip_at(-3), scene.rest(), lower, scene.rest());
    EXPECT_NEAR(value("tool_volume_inside", Moment::handled, step), 2 * prism_area(12, 4), 1e-9);
    EXPECT_NEAR(value("tool_volume_inside", Moment::deformed, step), 3 * prism_area(12, 4), 1e-9);
    EXPECT_LT(value("tool_points_inside", Moment::handled, step),
              value("tool_points_inside", Moment::deformed, step));
}

TEST(ToolInside, AtRestIsThatOfTheOrganAtRestWhereverItIsNow) {
    const JudgedSteps scene(box_organ({-20, -20, -40}, {20, 20, 0}, 3), make_prism(12));
    JudgedSteps::Positions lower = scene.rest();
    for (Vec3& p : lower) p.z() -= 2;
    Judged step = scene.step(tip_at(-3), lower, lower, lower);
    step.tool_at_beginning.position.z() += 2;  // the tool is where it went
    EXPECT_NEAR(value("tool_volume_at_rest", Moment::before, step), 3 * prism_area(12, 4), 1e-9);
    const JudgedSteps open(make_organ("open", make_organ_by_formula("sheet@10mm").rest), make_prism(12));
    EXPECT_EQ(why_missing("tool_volume_at_rest", Moment::before,
                          open.step(tip_at(-5), open.rest(), open.rest(), open.rest())),
              Missing::open_organ);
}

}  // namespace
}  // namespace trocar
