#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/metrics/judged.h"
#include "experiments/metrics/metric.h"

namespace trocar {
namespace {

Pose tip_at(double z) { return {.rotation = Mat3::Identity(), .position = {0, 0, z}}; }

double value(const std::string& name, Moment moment, const Judged& step) {
    for (const Metric& metric : all_metrics()) {
        if (metric.name == name) return metric.value(step, moment);
    }
    ADD_FAILURE() << "no metric " << name;
    return 0;
}

/// A closed box, its facets no longer than `edge` mm.
Organ box_organ(const Vec3& low, const Vec3& high, int cells) {
    SurfaceMesh mesh;
    std::map<std::array<int, 3>, Index> numbers;
    const auto corner = [&](std::array<int, 3> at) {
        const auto [found, fresh] = numbers.emplace(at, static_cast<Index>(mesh.positions.size()));
        if (fresh) {
            Vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * at[k] / cells;
            mesh.positions.push_back(p);
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, cells}) {
            for (int i = 0; i < cells; ++i) {
                for (int j = 0; j < cells; ++j) {
                    const auto at = [&](int u, int v) {
                        std::array<int, 3> cell{};
                        cell[axis] = side;
                        cell[(axis + 1) % 3] = u;
                        cell[(axis + 2) % 3] = v;
                        return corner(cell);
                    };
                    const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                    mesh.facets.push_back(side == 0 ? Facet{a, c, b} : Facet{a, b, c});
                    mesh.facets.push_back(side == 0 ? Facet{a, d, c} : Facet{a, c, d});
                }
            }
        }
    }
    return make_organ("box", mesh);
}

class TwoBoxes : public testing::TestWithParam<int> {};

TEST_P(TwoBoxes, OverlappingBy1500Micrometres) {
    // The tool stands with its tip 1.5 mm below the top of a box that is wider than it.
    const Organ organ = box_organ({-20, -20, -40}, {20, 20, 0}, GetParam());
    const Tool tool = make_prism(4, 11.3, 60);
    const ToolJudge judge(organ, tool);
    const JudgedMoment seen = judge.look(organ.rest.positions, tip_at(-1.5));
    Index on_top_below_tool = 0;
    for (const Vec3& p : organ.rest.positions) {
        if (p.z() == 0 && std::abs(p.x()) + std::abs(p.y()) < 11.3) ++on_top_below_tool;
    }
    EXPECT_EQ(seen.inside.size(), static_cast<std::size_t>(on_top_below_tool));
    for (std::size_t k = 0; k < seen.inside.size(); ++k) {
        const Vec3& p = organ.rest.positions[seen.inside[k]];
        const double to_side = (11.3 - std::abs(p.x()) - std::abs(p.y())) / std::numbers::sqrt2;
        EXPECT_NEAR(seen.depths[k], std::min(1.5, to_side), 1e-9);
    }
    EXPECT_GT(seen.facets_crossing, 0);

    const JudgedMoment apart = judge.look(organ.rest.positions, tip_at(1.5));
    EXPECT_TRUE(apart.inside.empty());
    EXPECT_EQ(apart.facets_crossing, 0);

    const JudgedMoment touching = judge.look(organ.rest.positions, tip_at(0));
    EXPECT_TRUE(touching.inside.empty()) << "on the surface is not inside";
    EXPECT_EQ(touching.facets_crossing, 0) << "touching is not crossing";
}
INSTANTIATE_TEST_SUITE_P(Resolutions, TwoBoxes, testing::Values(2, 5, 10, 20));

/// A step of the sheet in which some vertices are put somewhere by hand.
class JudgedSheet : public testing::Test {
  protected:
    const Organ organ_ = make_organ_by_formula("sheet@4mm");
    const Tool tool_ = make_prism(12);
    const ToolJudge judge_{organ_, tool_};
    const Pose pose_ = tip_at(-2);

    Judged judged(const std::vector<Vec3>& handled, const std::vector<Vec3>& deformed) {
        Judged step(organ_);
        step.moments = {judge_.look(organ_.rest.positions, pose_), judge_.look(handled, pose_),
                        judge_.look(deformed, pose_)};
        return step;
    }
    std::vector<Vec3> with_collided_at(double z) {
        std::vector<Vec3> positions = organ_.rest.positions;
        for (const Index vertex : judge_.look(positions, pose_).inside) positions[vertex].z() = z;
        return positions;
    }
};

TEST_F(JudgedSheet, CountsWhatHandlingLeavesInside) {
    const Judged step = judged(with_collided_at(-2.01), with_collided_at(-1.25));
    EXPECT_GT(value("collided_vertices", Moment::before, step), 2);
    EXPECT_EQ(value("vertices_inside", Moment::handled, step), 0);
    EXPECT_EQ(value("vertices_inside", Moment::deformed, step),
              value("collided_vertices", Moment::before, step));
    EXPECT_EQ(value("depth_max", Moment::handled, step), 0);
    EXPECT_TRUE(std::isnan(value("depth_mean", Moment::handled, step)));
    EXPECT_NEAR(value("depth_max", Moment::deformed, step), 0.75, 1e-9);
    EXPECT_LE(value("depth_mean", Moment::deformed, step), 0.75);
    EXPECT_GT(value("depth_mean", Moment::deformed, step), 0);
}

TEST_F(JudgedSheet, FacetsCrossWhereTheSheetRunsFromInsideToOutside) {
    const Judged step = judged(with_collided_at(-2.01), organ_.rest.positions);
    EXPECT_GT(value("facets_crossing", Moment::deformed, step), 0);
    // Handled vertices are below the tip, their neighbours beside it: facets between them cut its edge.
    EXPECT_GT(value("facets_crossing", Moment::handled, step), 0);
    std::vector<Vec3> away = organ_.rest.positions;
    for (Vec3& position : away) position.z() -= 5;
    EXPECT_EQ(value("facets_crossing", Moment::handled, judged(away, away)), 0);
}

TEST_F(JudgedSheet, MeasuresHowFarHandlingMoved) {
    const Judged step = judged(with_collided_at(-2.01), organ_.rest.positions);
    EXPECT_NEAR(value("displacement_mean", Moment::handled, step), 2.01, 1e-12);
    EXPECT_NEAR(value("displacement_max", Moment::handled, step), 2.01, 1e-12);

    std::vector<Vec3> one_more = with_collided_at(-2.01);
    one_more[judge_.look(organ_.rest.positions, pose_).inside.front()].z() = -3;
    const Judged uneven = judged(one_more, organ_.rest.positions);
    EXPECT_EQ(value("displacement_max", Moment::handled, uneven), 3);
    EXPECT_GT(value("displacement_mean", Moment::handled, uneven), 2.01);
}

TEST_F(JudgedSheet, WithoutContactThereAreNoDisplacements) {
    Judged step(organ_);
    for (JudgedMoment& moment : step.moments) moment = judge_.look(organ_.rest.positions, tip_at(5));
    EXPECT_EQ(value("collided_vertices", Moment::before, step), 0);
    EXPECT_TRUE(std::isnan(value("displacement_mean", Moment::handled, step)));
    EXPECT_TRUE(std::isnan(value("displacement_max", Moment::handled, step)));
    EXPECT_EQ(value("flipped_facets", Moment::handled, step), 0);
}

TEST_F(JudgedSheet, CountsFacetsThatHandlingTurnsOver) {
    Index inner = 0;
    while (organ_.adjacency.on_boundary(inner)) ++inner;
    // Drawn far over a neighbour, the vertex turns over the facets on that side.
    std::vector<Vec3> folded = organ_.rest.positions;
    folded[inner].x() += 7;
    Index expected = 0;
    for (const Index facet : organ_.adjacency.ring(inner)) {
        if (facet_normal(folded, organ_.rest.facets[facet]).z() < 0) ++expected;
    }
    ASSERT_GT(expected, 0);
    EXPECT_EQ(value("flipped_facets", Moment::handled, judged(folded, folded)), expected);
    // Tilted by less than 90° is not flipped.
    std::vector<Vec3> tilted = organ_.rest.positions;
    tilted[inner].z() += 30;
    EXPECT_EQ(value("flipped_facets", Moment::handled, judged(tilted, tilted)), 0);
}

TEST_F(JudgedSheet, PassesOnWhatTheStrategyCounted) {
    Judged step(organ_);
    step.fallbacks = 7;
    EXPECT_EQ(value("fallbacks", Moment::handled, step), 7);
}

TEST_F(JudgedSheet, FarFromTheToolThereIsNothingToImprove) {
    Judged step(organ_);
    for (JudgedMoment& moment : step.moments) moment = judge_.look(organ_.rest.positions, tip_at(5));
    for (const Metric& metric : all_metrics()) {
        if (metric.better != "low") continue;
        for (const Moment moment : metric.moments) {
            const double found = metric.value(step, moment);
            EXPECT_TRUE(found == 0 || std::isnan(found)) << metric.name << " is " << found;
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
    EXPECT_EQ(series_name(all_metrics()[0], Moment::before), "collided_vertices");
    EXPECT_EQ(series_name(all_metrics()[1], Moment::handled), "vertices_inside_h");
    EXPECT_EQ(series_name(all_metrics()[1], Moment::deformed), "vertices_inside_d");
}

}  // namespace
}  // namespace trocar
