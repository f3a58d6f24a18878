// Metrics of the organ's shape after deformation: strain, jitter, recovery, volume_change; and the fixed
// region.

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "box_organ.h"
#include "common/geometry/organ_shapes.h"
#include "square.h"

namespace trocar {
namespace {

using Positions = std::vector<Vec3>;

Judged deformed(const JudgedSteps& steps, const Positions& found, const Positions& after) {
    return steps.step(tip_at(50), found, found, after);
}

TEST(Strain, IsTheRootMeanSquareOfTheLengthening) {
    const Square square;
    Positions wide = square.steps().rest();
    for (Vec3& position : wide) position.x() *= 3;
    // Lengths 1, 1, 1, 1, √2 become 3, 1, 3, 1, √10.
    const double across = std::sqrt(5.0) - 1;
    EXPECT_NEAR(value("strain", Moment::deformed, deformed(square.steps(), wide, wide)),
                std::sqrt((4 + 0 + 4 + 0 + across * across) / 5), 1e-14);
    EXPECT_EQ(value("strain", Moment::deformed, deformed(square.steps(), wide, square.steps().rest())), 0);
}

TEST(Strain, SeesTheRegionsEdgesOnly) {
    Square square;
    JudgedSteps& steps = square.steps();
    steps.set_region({0, 1, 3});  // edges 0–1 and 0–3
    Positions wide = steps.rest();
    for (Vec3& position : wide) position.x() *= 3;
    EXPECT_NEAR(value("strain", Moment::deformed, deformed(steps, wide, wide)), std::sqrt(4 / 2.0), 1e-14);
    steps.set_region({1, 3});
    EXPECT_EQ(why_missing("strain", Moment::deformed, deformed(steps, wide, wide)), Missing::empty_region);
}

TEST(Jitter, IsTheMeanSecondDifference) {
    Square square;
    JudgedSteps& steps = square.steps();
    steps.set_region({0, 1});
    Positions first = steps.rest(), second = first, third = first;
    second[0].x() += 1;  // 0, 1, 5: second difference 3
    third[0].x() += 5;
    second[1].y() += 2;  // 0, 2, 4: moves evenly
    third[1].y() += 4;
    third[2].z() += 100;  // not in the region
    Judged step = deformed(steps, second, third);
    EXPECT_EQ(why_missing("jitter", Moment::deformed, step), Missing::too_early);
    step.step_before = first;
    EXPECT_NEAR(value("jitter", Moment::deformed, step), 1.5, 1e-14);
    steps.set_region({});
    EXPECT_EQ(why_missing("jitter", Moment::deformed, step), Missing::empty_region);
}

TEST(Jitter, IsThereFromTheSecondStepOn) {
    const Square square;
    const JudgedSteps& steps = square.steps();
    Judge judge(
        steps.state(steps.rest(), tip_at(50)),
        {.metrics = choose_metrics("jitter"), .region = region_of(steps.judged_organ(), {0}), .every = 1});
    Positions positions = steps.rest();
    std::vector<double> jitters;
    for (int k = 1; k <= 4; ++k) {  // the vertex goes 0, 1, 4, 9, 16
        judge.before(positions, tip_at(50));
        judge.handled(positions, 0);
        positions[0].x() = steps.rest()[0].x() + k * k;
        judge.deformed(positions);
        jitters.push_back(judge.values().at(0).value);
    }
    EXPECT_TRUE(std::isnan(jitters[0]));
    for (int k = 1; k < 4; ++k) EXPECT_NEAR(jitters[k], 2, 1e-13);
}

TEST(Recovery, IsTheRootMeanSquareDistanceToRest) {
    Square square;
    JudgedSteps& steps = square.steps();
    steps.set_region({0, 1, 2});
    Positions left = steps.rest();
    left[0] += Vec3(3, 4, 0);
    left[1] += Vec3(0, 0, 1);
    left[3] += Vec3(9, 9, 9);  // not in the region
    EXPECT_NEAR(value("recovery", Moment::end, deformed(steps, steps.rest(), left)), std::sqrt(26 / 3.0),
                1e-14);
    EXPECT_EQ(value("recovery", Moment::end, deformed(steps, left, steps.rest())), 0);
    steps.set_region({});
    EXPECT_EQ(why_missing("recovery", Moment::end, deformed(steps, left, left)), Missing::empty_region);
}

TEST(Recovery, IsTakenOnceAfterTheLastStep) {
    const Square square;
    const JudgedSteps& steps = square.steps();
    Judge judge(steps.state(steps.rest(), tip_at(50)),
                {.metrics = choose_metrics("recovery,strain"),
                 .region = region_of(steps.judged_organ(), {0, 1, 2, 3}),
                 .every = 1});
    Positions moved = steps.rest();
    for (Vec3& position : moved) position.z() += 2;
    judge.before(steps.rest(), tip_at(50));
    judge.handled(steps.rest(), 0);
    judge.deformed(moved);
    EXPECT_EQ(judge.values().size(), 1U) << "strain only";
    ASSERT_EQ(judge.values_at_end().size(), 1U);
    EXPECT_NEAR(judge.values_at_end()[0].value, 2, 1e-14);
}

TEST(VolumeChange, IsTheChangeOfTheEnclosedVolume) {
    for (const int cells : {1, 3, 8}) {
        const JudgedSteps box(box_organ({100, 200, 300}, {110, 205, 302}, cells), make_prism(12));
        Positions larger = box.rest();
        for (Vec3& position : larger) position.x() = 100 + 1.25 * (position.x() - 100);
        EXPECT_NEAR(value("volume_change", Moment::deformed, deformed(box, box.rest(), larger)), 0.25, 1e-12);
        Positions flat = box.rest();
        for (Vec3& position : flat) position.z() = 300;
        EXPECT_NEAR(value("volume_change", Moment::deformed, deformed(box, box.rest(), flat)), -1, 1e-12);
    }
}

TEST(VolumeChange, IsMissingForAnOpenOrgan) {
    const JudgedSteps sheet(make_organ_by_formula("sheet@6mm"), make_prism(12));
    EXPECT_EQ(why_missing("volume_change", Moment::deformed, deformed(sheet, sheet.rest(), sheet.rest())),
              Missing::open_organ);
}

double distance_to_axis_box(const Vec3& point, double radius, double low) {
    // A square prism turned by 45°: its corners on the axes x and y, each side at radius / √2.
    const double u = (std::abs(point.x()) + std::abs(point.y())) / std::numbers::sqrt2;
    const double beside = std::max(0.0, u - radius / std::numbers::sqrt2);
    return std::hypot(beside, std::max(0.0, low - point.z()));
}

TEST(FixedRegion, HoldsWhatComesWithinTwoRadiiOfTheSweep) {
    const Organ sheet = make_organ_by_formula("sheet@4mm");
    const Tool tool = make_prism(4, 4, 60);
    // From 30 mm to 2 mm above the sheet in one step: 8 mm from the surface is reached at the end.
    const std::vector<Pose> poses{tip_at(2)};
    const std::vector<Index> near = vertices_near_sweep(sheet, tool, tip_at(30), poses);
    std::vector<Index> expected;
    for (std::size_t vertex = 0; vertex < sheet.rest.positions.size(); ++vertex) {
        const Vec3& p = sheet.rest.positions[vertex];
        // Beyond the corners of the square the distance is larger than this bound; leave those out.
        const double side = std::abs(std::abs(p.x()) - std::abs(p.y())) / std::numbers::sqrt2;
        const bool beside_a_face = side <= 4 / std::numbers::sqrt2;
        const bool within = distance_to_axis_box(p, 4, 2) <= 8;
        const bool in_region = std::ranges::binary_search(near, static_cast<Index>(vertex));
        if (beside_a_face) {
            EXPECT_EQ(in_region, within) << p.transpose();
        }
        if (!within) {
            EXPECT_FALSE(in_region) << p.transpose();
        }
    }
    EXPECT_FALSE(near.empty());
    EXPECT_TRUE(std::ranges::is_sorted(near));
}

TEST(FixedRegion, SeesWhatIsSweptBetweenTwoPoses) {
    const Organ sheet = make_organ_by_formula("sheet@4mm");
    const Tool tool = make_prism(12, 2, 60);
    const Pose left{.rotation = Mat3::Identity(), .position = {-40, 0, 0.5}};
    const std::vector<Pose> one_step{{.rotation = Mat3::Identity(), .position = {40, 0, 0.5}}};
    const std::vector<Index> near = vertices_near_sweep(sheet, tool, left, one_step);
    for (std::size_t vertex = 0; vertex < sheet.rest.positions.size(); ++vertex) {
        const Vec3& p = sheet.rest.positions[vertex];
        const bool in_region = std::ranges::binary_search(near, static_cast<Index>(vertex));
        if (std::abs(p.x()) < 40 && std::abs(p.y()) < 5.5) {
            EXPECT_TRUE(in_region) << p.transpose();
        }
        if (std::abs(p.y()) > 6) {
            EXPECT_FALSE(in_region) << p.transpose();
        }
    }
}

TEST(FixedRegion, HoldsVerticesInsideTheTool) {
    const Organ box = box_organ({-1, -1, -1}, {1, 1, 1}, 2);
    const Tool wide = make_prism(12, 50, 200);
    const std::vector<Index> near = vertices_near_sweep(box, wide, tip_at(-100), {});
    EXPECT_EQ(near.size(), box.rest.positions.size());
}

}  // namespace
}  // namespace trocar
