#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "box_organ.h"
#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "judged_steps.h"

namespace trocar {
namespace {

using testing::HasSubstr;

class TwoBoxes : public testing::TestWithParam<int> {};

TEST_P(TwoBoxes, OverlappingBy1500Micrometres) {
    // The tool stands with its tip 1.5 mm below the top of a box that is wider than it.
    const JudgedSteps boxes(box_organ({-20, -20, -40}, {20, 20, 0}, GetParam()), make_prism(4, 11.3, 60));
    const JudgedState seen = boxes.state(boxes.rest(), tip_at(-1.5));
    Index on_top_below_tool = 0;
    for (const Vec3& p : boxes.rest()) {
        if (p.z() == 0 && std::abs(p.x()) + std::abs(p.y()) < 11.3) ++on_top_below_tool;
    }
    EXPECT_EQ(seen.inside().size(), static_cast<std::size_t>(on_top_below_tool));
    for (std::size_t k = 0; k < seen.inside().size(); ++k) {
        const Vec3& p = boxes.rest()[seen.inside()[k]];
        const double to_side = (11.3 - std::abs(p.x()) - std::abs(p.y())) / std::numbers::sqrt2;
        EXPECT_NEAR(seen.depths()[k], std::min(1.5, to_side), 1e-9);
    }
    EXPECT_FALSE(seen.crossing_facets().empty());

    const JudgedState apart = boxes.state(boxes.rest(), tip_at(1.5));
    EXPECT_TRUE(apart.inside().empty());
    EXPECT_TRUE(apart.crossing_facets().empty());

    const JudgedState touching = boxes.state(boxes.rest(), tip_at(0));
    EXPECT_TRUE(touching.inside().empty()) << "on the surface is not inside";
    EXPECT_TRUE(touching.crossing_facets().empty()) << "touching is not crossing";
}
INSTANTIATE_TEST_SUITE_P(Resolutions, TwoBoxes, testing::Values(2, 5, 10, 20));

/// A step of the sheet in which some vertices are put somewhere by hand.
class JudgedSheet : public testing::Test {
  protected:
    using Positions = JudgedSteps::Positions;

    const JudgedSteps sheet_{make_organ_by_formula("sheet@4mm"), make_prism(12)};
    const Pose pose_ = tip_at(-2);

    [[nodiscard]] Judged judged(const Positions& handled, const Positions& deformed) const {
        return sheet_.step(pose_, sheet_.rest(), handled, deformed);
    }
    [[nodiscard]] Positions with_collided_at(double z) const {
        Positions positions = sheet_.rest();
        const JudgedState found = sheet_.state(positions, pose_);
        for (const Index vertex : found.inside()) positions[vertex].z() = z;
        return positions;
    }
    [[nodiscard]] Judged far_away() const {
        return sheet_.step(tip_at(5), sheet_.rest(), sheet_.rest(), sheet_.rest());
    }
};

TEST_F(JudgedSheet, CountsWhatHandlingLeavesInside) {
    const Judged step = judged(with_collided_at(-2.01), with_collided_at(-1.25));
    EXPECT_GT(value("collided_vertices", Moment::before, step), 2);
    EXPECT_EQ(value("vertices_inside", Moment::handled, step), 0);
    EXPECT_EQ(value("vertices_inside", Moment::deformed, step),
              value("collided_vertices", Moment::before, step));
    EXPECT_EQ(value("depth_max", Moment::handled, step), 0);
    EXPECT_EQ(why_missing("depth_mean", Moment::handled, step), Missing::no_vertex_inside);
    EXPECT_NEAR(value("depth_max", Moment::deformed, step), 0.75, 1e-9);
    EXPECT_LE(value("depth_mean", Moment::deformed, step), 0.75);
    EXPECT_GT(value("depth_mean", Moment::deformed, step), 0);
}

TEST_F(JudgedSheet, TheDeepestVertexIsNotTheMeanOne) {
    Positions uneven = with_collided_at(-1.25);
    const auto from_axis = [&](Index vertex) { return uneven[vertex].head<2>().norm(); };
    const JudgedState found = sheet_.state(sheet_.rest(), pose_);
    uneven[std::ranges::min(found.inside(), {}, from_axis)].z() = -1;
    const Judged step = judged(uneven, uneven);
    EXPECT_NEAR(value("depth_max", Moment::deformed, step), 1, 1e-9);
    const auto count = static_cast<double>(found.inside().size());
    EXPECT_NEAR(value("depth_mean", Moment::deformed, step), 0.75 + 0.25 / count, 1e-9);
}

TEST_F(JudgedSheet, FacetsCrossWhereTheSheetRunsFromInsideToOutside) {
    const Judged step = judged(with_collided_at(-2.01), sheet_.rest());
    EXPECT_GT(value("facets_crossing", Moment::deformed, step), 0);
    // Handled vertices are below the tip, their neighbours beside it: facets between them cut its edge.
    EXPECT_GT(value("facets_crossing", Moment::handled, step), 0);
    Positions away = sheet_.rest();
    for (Vec3& position : away) position.z() -= 5;
    const Judged back_again = judged(away, sheet_.rest());
    EXPECT_EQ(value("facets_crossing", Moment::handled, back_again), 0);
    EXPECT_GT(value("facets_crossing", Moment::deformed, back_again), 0);
}

TEST_F(JudgedSheet, MeasuresHowFarHandlingMoved) {
    const Judged step = judged(with_collided_at(-2.01), sheet_.rest());
    EXPECT_NEAR(value("displacement_mean", Moment::handled, step), 2.01, 1e-12);
    EXPECT_NEAR(value("displacement_max", Moment::handled, step), 2.01, 1e-12);

    Positions one_more = with_collided_at(-2.01);
    one_more[step.collided().front()].z() = -3;
    const Judged uneven = judged(one_more, sheet_.rest());
    EXPECT_EQ(value("displacement_max", Moment::handled, uneven), 3);
    EXPECT_GT(value("displacement_mean", Moment::handled, uneven), 2.01);
}

TEST_F(JudgedSheet, WithoutContactThereAreNoDisplacements) {
    const Judged step = far_away();
    EXPECT_EQ(value("collided_vertices", Moment::before, step), 0);
    EXPECT_EQ(why_missing("displacement_mean", Moment::handled, step), Missing::no_vertex_collided);
    EXPECT_EQ(why_missing("displacement_max", Moment::handled, step), Missing::no_vertex_collided);
    EXPECT_EQ(value("flipped_facets", Moment::handled, step), 0);
}

TEST_F(JudgedSheet, CountsFacetsThatHandlingTurnsOver) {
    const Organ& organ = sheet_.organ();
    Index inner = 0;
    while (organ.adjacency.on_boundary(inner)) ++inner;
    // Drawn far over a neighbour, the vertex turns over the facets on that side.
    Positions folded = sheet_.rest();
    folded[inner].x() += 7;
    Index expected = 0;
    for (const Index facet : organ.adjacency.ring(inner)) {
        if (facet_normal(folded, organ.rest.facets[facet]).z() < 0) ++expected;
    }
    ASSERT_GT(expected, 0);
    EXPECT_EQ(value("flipped_facets", Moment::handled, judged(folded, folded)), expected);
    // What the step found folded and handling leaves so, handling has not flipped.
    const Judged found_folded = sheet_.step(pose_, folded, folded, folded);
    EXPECT_EQ(value("flipped_facets", Moment::handled, found_folded), 0);
    // Tilted by less than 90° is not flipped.
    Positions tilted = sheet_.rest();
    tilted[inner].z() += 30;
    EXPECT_EQ(value("flipped_facets", Moment::handled, judged(tilted, tilted)), 0);
}

TEST_F(JudgedSheet, PassesOnWhatTheStrategyCounted) {
    Judged step = judged(sheet_.rest(), sheet_.rest());
    step.fallbacks = 7;
    EXPECT_EQ(value("fallbacks", Moment::handled, step), 7);
}

TEST_F(JudgedSheet, FarFromTheToolThereIsNothingToImprove) {
    const Judged step = far_away();
    for (const Metric& metric : all_metrics()) {
        if (metric.better != "low") continue;
        for (const Moment moment : metric.moments) {
            const Measured found = metric.value(step, moment);
            EXPECT_TRUE(found.value == 0 || found.missing != Missing::nothing)
                << metric.name << " is " << found.value;
        }
    }
}

TEST(Metrics, HaveNamesUnitsAndDefinitions) {
    std::set<std::string> names;
    for (const Metric& metric : all_metrics()) {
        EXPECT_FALSE(metric.name.empty());
        EXPECT_TRUE(names.insert(metric.name).second) << metric.name << " is there twice";
        EXPECT_FALSE(metric.units.empty()) << metric.name;
        EXPECT_FALSE(metric.definition.empty()) << metric.name;
        EXPECT_FALSE(metric.moments.empty()) << metric.name;
        EXPECT_TRUE(metric.better == "low" || metric.better == "high" || metric.better == "neither")
            << metric.name;
    }
}

TEST(Metrics, NameTheirSeriesByMomentWhereThereAreTwo) {
    EXPECT_EQ(series_name(metric_named("collided_vertices"), Moment::before), "collided_vertices");
    EXPECT_EQ(series_name(metric_named("vertices_inside"), Moment::handled), "vertices_inside_h");
    EXPECT_EQ(series_name(metric_named("vertices_inside"), Moment::deformed), "vertices_inside_d");
}

TEST(Metrics, AreChosenByNameOrByCost) {
    EXPECT_EQ(choose_metrics("all").size(), all_metrics().size());
    for (const Metric* metric : choose_metrics("fast")) EXPECT_EQ(metric->cost, Cost::low) << metric->name;
    const auto two = choose_metrics("depth_max,collided_vertices");
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two.front()->name, "collided_vertices") << "in the order of the list";
    try {
        choose_metrics("depth_max,depth_meam");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean \"depth_mean\""));
    }
    EXPECT_THROW(choose_metrics(""), std::invalid_argument);
}

TEST(Judge, LooksAtMostThirtyTimesASecond) {
    EXPECT_EQ(sampled_every(10), 1);
    EXPECT_EQ(sampled_every(30), 1);
    EXPECT_EQ(sampled_every(31), 2);
    EXPECT_EQ(sampled_every(60), 2);
    EXPECT_EQ(sampled_every(1000), 34);
}

TEST(Judge, LeavesTheStepsBetweenWithoutValues) {
    const JudgedSteps sheet(make_organ_by_formula("sheet@4mm"), make_prism(12));
    Judge judge(sheet.state(sheet.rest(), tip_at(0)),
                {.metrics = choose_metrics("collided_vertices"), .region = {}, .every = 2});
    for (int step = 1; step <= 4; ++step) {
        judge.before(sheet.rest(), tip_at(-0.5 * step));
        judge.handled(sheet.rest(), 0);
        judge.deformed(sheet.rest());
        const Measured value = judge.values().at(0);
        EXPECT_EQ(value.missing, step % 2 == 0 ? Missing::nothing : Missing::not_sampled) << step;
        if (step % 2 == 0) {
            EXPECT_GT(value.value, 0);
        }
    }
}

}  // namespace
}  // namespace trocar
