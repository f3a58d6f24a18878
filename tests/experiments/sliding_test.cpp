// The scene `sliding`, and the way along the surface that it goes.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/scenes/mean_normal.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/surface_way.h"
#include "experiments/scenes/window.h"
#include "stage.h"

namespace trocar {
namespace {

constexpr double dt = 1.0 / 30;
constexpr std::size_t hold_steps = 15, rest_steps = 30;
constexpr double degree = std::numbers::pi / 180;

Vec3 axis(const Pose& pose) { return pose.rotation.col(2); }

/// Where the tip, 3 mm below the surface, would be upon it.
Vec3 above(const Pose& pose) { return pose.position + 3 * axis(pose); }

/// `sliding` laid out, and the poses of its slide, the start first.
struct Slide {
    explicit Slide(const SceneInputs& given) : inputs(given), at(find_scene("sliding").place(inputs)) {
        lay_out();
    }
    Slide(const Stage& stage, double speed, std::uint64_t seed) : Slide(stage.inputs(speed, seed)) {}
    void lay_out() {
        plan = find_scene("sliding").plan(inputs, at);
        const auto held = std::ranges::adjacent_find(
            plan.poses, [](const Pose& a, const Pose& b) { return a.position == b.position; });
        poses.assign(plan.poses.begin(), held + 1);
        poses.insert(poses.begin(), plan.start);
    }
    [[nodiscard]] double tip_way() const {
        double way = 0;
        for (std::size_t k = 1; k < poses.size(); ++k) way += step(k);
        return way;
    }
    [[nodiscard]] double step(std::size_t k) const {
        return (poses[k].position - poses[k - 1].position).norm();
    }

    SceneInputs inputs;
    Placement at;
    ScenePlan plan;
    std::vector<Pose> poses;
};

class SlidingOn : public testing::TestWithParam<std::string> {
  protected:
    [[nodiscard]] static const Stage& stage() {
        static std::map<std::string, Stage> made;
        return made.try_emplace(GetParam(), GetParam()).first->second;
    }
};
INSTANTIATE_TEST_SUITE_P(Organs, SlidingOn,
                         testing::Values("sphere@4mm", "gallbladder@3mm", "liver@5mm", "cleft@5mm",
                                         "rough-sheet@4mm"),
                         [](const auto& tested) {
                             std::string name = tested.param.substr(0, tested.param.find('@'));
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST_P(SlidingOn, TouchesTheOrganAllTheWay) {
    for (const double speed : {20.0, 100.0, 400.0}) {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const Slide slide(stage(), speed, seed);
            const std::vector<bool> window = window_of(slide.inputs, slide.poses);
            EXPECT_GE(std::ranges::count(window, true), 0.9 * static_cast<double>(window.size()))
                << "seed " << seed << ", " << speed << " mm/s";
        }
    }
}

TEST_P(SlidingOn, StaysUprightThreeMillimetresBelowTheSurfaceForThirtyMillimetres) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Slide slide(stage(), 20, seed);
        std::vector<double> depths;
        double along = 0;
        for (std::size_t k = 0; k < slide.poses.size(); ++k) {
            const Vec3 on = above(slide.poses[k]);
            if (k > 0) along += (on - above(slide.poses[k - 1])).norm();
            depths.push_back(stage().queries.distance(slide.poses[k].position));
            const SurfacePoint under = stage().queries.closest(on, 0);
            // Between two points of the way a chord of a millimetre, across the edges and corners there.
            EXPECT_LT((under.position - on).norm(), 0.3);
            const Vec3 normal = mean_normal(stage().organ, under.position, under.facet, 8).value();
            // The mean leaps a little where facets come into its circle and go.
            EXPECT_GT(normal.dot(axis(slide.poses[k])), std::cos(10 * degree)) << "upright";
        }
        EXPECT_NEAR(along, 30, 0.3) << "up to what chords of 0.7 mm cut off, seed " << seed;
        // No further from the surface than from the point above, but for the sagitta of a chord of 1 mm at a
        // radius of curvature of 2.5 mm; nearer where the facets there lean against the mean normal, down to
        // the half that a placement allows, but not everywhere.
        EXPECT_LE(std::ranges::max(depths), 3.05) << "seed " << seed;
        EXPECT_GE(std::ranges::min(depths), 1.5) << "seed " << seed;
        std::ranges::sort(depths);
        EXPECT_GE(depths[depths.size() / 2], 2) << "seed " << seed;
    }
}

TEST_P(SlidingOn, GoesTheSameWayAtEverySpeedAsFastAsItShould) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Slide rapid(stage(), 400, seed), moderate(stage(), 100, seed), slow(stage(), 1, seed);
        const double length = slow.tip_way();
        for (const Slide* slide : {&rapid, &moderate}) {
            EXPECT_EQ(slide->plan.start.position, slow.plan.start.position);
            EXPECT_EQ(slide->poses.back().position, slow.poses.back().position) << "exactly";
            EXPECT_EQ(slide->poses.back().rotation, slow.poses.back().rotation);
            const double full = slide->inputs.speed * dt;
            EXPECT_LE(slide->step(1), slide->at.phase * full + 1e-9);
            for (std::size_t k = 2; k < slide->poses.size(); ++k) EXPECT_LE(slide->step(k), full + 1e-9);
            // Start, a step of the phase's part, full steps, and one for what is left.
            EXPECT_EQ(slide->poses.size(), 2 + std::ceil((length - slide->at.phase * full) / full));
        }
        // Without a phase a rapid step is four moderate ones.
        for (Slide* slide : {&rapid, &moderate}) {
            slide->at.phase = 0;
            slide->lay_out();
        }
        for (std::size_t k = 1; k + 1 < rapid.poses.size(); ++k) {
            const Pose &there = rapid.poses[k], &passed = moderate.poses.at(4 * k - 3);
            EXPECT_TRUE(there.position.isApprox(passed.position, 1e-12));
            EXPECT_TRUE(there.rotation.isApprox(passed.rotation, 1e-12));
        }
    }
}

TEST_P(SlidingOn, HoldsAndLeavesAlongTheNormalWhereItEnds) {
    const Slide slide(stage(), 100, 2);
    const Pose& end = slide.poses.back();
    const std::vector<Pose>& all = slide.plan.poses;
    const std::size_t arrival = slide.poses.size() - 2;  // the start is no step
    for (std::size_t k = arrival; k < all.size(); ++k) {
        EXPECT_EQ(all[k].rotation, end.rotation);
        const Vec3 way = all[k].position - end.position;
        EXPECT_LT((way - way.dot(axis(end)) * axis(end)).norm(), 1e-9);
        EXPECT_EQ(k <= arrival + hold_steps, all[k].position == end.position) << "half a second of hold";
        EXPECT_EQ(k + 1 + rest_steps >= all.size(), all[k].position == all.back().position);
    }
    EXPECT_NEAR((all.back().position - end.position).norm(), 6, 1e-9) << "3 mm clear";
    EXPECT_FALSE(window_of(slide.inputs, {all.back()}).front());
    ASSERT_TRUE(slide.plan.insertion);
    EXPECT_TRUE(slide.plan.insertion->direction.isApprox(-slide.at.normal));
    EXPECT_NEAR(slide.plan.insertion->length, 6, 1e-12);
}

TEST(Sliding, GoesAlongAGreatCircleOfASphere) {
    const Stage sphere("sphere@2mm");
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Slide slide(sphere, 20, seed);
        const Vec3 across = slide.at.normal.cross(slide.at.tangent);
        for (const Pose& pose : slide.poses) {
            EXPECT_NEAR(pose.position.norm(), 37, 0.05);
            EXPECT_GT(axis(pose).dot(pose.position.normalized()), std::cos(1 * degree));
            EXPECT_NEAR(pose.position.dot(across), slide.poses[0].position.dot(across), 0.3) << "straight on";
        }
        const double turn = std::acos(axis(slide.poses[0]).dot(axis(slide.poses.back())));
        EXPECT_NEAR(turn, 30.0 / 40, 0.02);
        EXPECT_NEAR(slide.tip_way(), 30.0 * 37 / 40, 0.2);
    }
}

TEST(Sliding, GoesStraightOnASheet) {
    const Stage sheet("sheet@4mm");
    const Slide slide(sheet, 100, 3);
    for (std::size_t k = 0; k < slide.poses.size(); ++k) {
        const double gone =
            k == 0 ? 0 : std::min(30.0, (slide.at.phase + static_cast<double>(k) - 1) * 100 * dt);
        const Pose expected =
            upright_pose(slide.at, slide.at.entry - 3 * slide.at.normal + gone * slide.at.tangent);
        EXPECT_LT((slide.poses[k].position - expected.position).norm(), 1e-9);
        EXPECT_TRUE(slide.poses[k].rotation.isApprox(expected.rotation, 1e-12));
    }
}

TEST(Sliding, HasNoPlaceOnATubeWhoseWallIsThinnerThanTwiceItsDepth) {
    // Without a least depth of the tip it would go around the rims, in and out of the wall.
    const Stage tube("tube@4mm");
    const std::string reason = unsuited(find_scene("sliding"), tube.inputs(100, 1));
    EXPECT_THAT(reason, testing::HasSubstr("at least 6 mm thick"));
    EXPECT_THAT(reason, testing::HasSubstr("for 30 mm along the surface"));
}

TEST(Sliding, TheWholeWayIsAsTheEntryPointHasToBe) {
    const Stage sheet("rough-sheet@5mm"), liver("liver@5mm");
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Slide on_sheet(sheet, 20, seed), on_liver(liver, 20, seed);
        for (const Pose& pose : on_sheet.poses) {
            EXPECT_LE(above(pose).head<2>().cwiseAbs().maxCoeff(), 60 - 8 + 0.1) << "two radii inland";
        }
        std::vector<Pose> clear = on_liver.poses;
        for (Pose& pose : clear) pose.position = above(pose) + 3 * axis(pose);
        EXPECT_THAT(window_of(on_liver.inputs, clear), testing::Each(false)) << "no other wall in the way";
    }
}

TEST(Sliding, StaysWhereTheOrganIsTwiceAsThickAsItIsDeep) {
    Stage lens("sphere@4mm");
    SurfaceMesh squashed = lens.organ.rest;
    for (Vec3& position : squashed.positions) position = position.cwiseProduct(Vec3(3, 3, 0.12));  // 9.6 mm
    lens.organ = make_organ("lens", squashed);
    const SurfaceQueries queries(lens.organ.rest);
    double thinnest = 99;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const SceneInputs given = lens.inputs(20, seed);
        const SceneInputs inputs{.organ = lens.organ,
                                 .organ_queries = queries,
                                 .tool = lens.tool,
                                 .speed = given.speed,
                                 .dt = given.dt,
                                 .seed = seed};
        for (const Pose& pose : Slide(inputs).poses) {
            const auto through = queries.distance_to_exit(pose.position, -axis(pose), 0);
            ASSERT_TRUE(through);
            thinnest = std::min(thinnest, 3 + *through);
        }
    }
    EXPECT_GT(thinnest, 6 - 0.1);
    EXPECT_LT(thinnest, 7) << "it was put to the test";
}

TEST(SurfaceWay, EndsWhereTheSurfaceEnds) {
    const Stage sheet("sheet@6mm");
    const SceneInputs inputs = sheet.inputs(100, 1);
    Pose start;
    start.position = {29, 0, 0};  // the boundary is 31 mm ahead
    const auto way = surface_way(inputs, start, 30);
    ASSERT_TRUE(way);
    EXPECT_LT((way->back().position - Vec3(59, 0, 0)).norm(), 1e-9);
    EXPECT_FALSE(surface_way(inputs, start, 32));
}

TEST(SurfaceWay, EndsWhereTheSurfaceIsSharp) {
    // To a needle, which is narrower than a facet, each edge of an icosahedron is sharp: 42 degrees.
    const Stage icosahedron("sphere@40mm", "needle");
    const auto [a, b, c] = icosahedron.organ.rest.facets[0];
    const auto& corners = icosahedron.organ.rest.positions;
    Pose start;
    start.position = (corners[a] + corners[b] + corners[c]) / 3;
    const Vec3 normal = icosahedron.organ.rest_normals[0];
    const Vec3 ahead = ((corners[a] + corners[b]) / 2 - start.position).normalized();
    start.rotation << ahead, normal.cross(ahead), normal;
    const double to_edge = ((corners[a] + corners[b]) / 2 - start.position).norm();
    EXPECT_TRUE(surface_way(icosahedron.inputs(100, 1), start, to_edge - 2));
    EXPECT_FALSE(surface_way(icosahedron.inputs(100, 1), start, to_edge + 2));
}

TEST(SurfaceWay, ReachesTheLengthAskedForExactly) {
    const Stage sphere("sphere@4mm");
    const Slide slide(sphere, 100, 1);
    for (const double length : {0.3, 1.0, 7.7, 30.0}) {
        const auto way = surface_way(slide.inputs, upright_pose(slide.at, slide.at.entry), length);
        ASSERT_TRUE(way);
        Vec3 last = slide.at.entry;
        double gone = 0;
        for (const Pose& pose : *way) {
            gone += (pose.position - last).norm();
            EXPECT_TRUE((pose.rotation * pose.rotation.transpose()).isApprox(Mat3::Identity(), 1e-12));
            EXPECT_GT(pose.rotation.col(0).dot(pose.position - last), 0.99 * (pose.position - last).norm())
                << "the x axis points along the way";
            last = pose.position;
        }
        EXPECT_NEAR(gone, length, 1e-9);
    }
}

}  // namespace
}  // namespace trocar
