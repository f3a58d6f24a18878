// The made-up steps that the pages of the metrics show.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/metrics/examples/example.h"

namespace trocar {
namespace {

TEST(Examples, AreOfEveryMetricInItsOrder) {
    const std::vector<Example>& examples = all_examples();
    ASSERT_EQ(examples.size(), all_metrics().size());
    for (std::size_t k = 0; k < examples.size(); ++k) EXPECT_EQ(examples[k].metric, all_metrics()[k].name);
}

TEST(Examples, HaveTheValueThatTheyWereMadeFor) {
    for (const Example& example : all_examples()) {
        EXPECT_NEAR(judge_example(example).value, example.expected, example.tolerance) << example.metric;
        EXPECT_GT(std::abs(example.expected), 0) << example.metric << ": nothing to see";
    }
}

TEST(Examples, AreJudgedWhenTheMetricIsTaken) {
    for (const Example& example : all_examples()) {
        const Metric& metric = *choose_metrics(example.metric).front();
        EXPECT_TRUE(std::ranges::find(metric.moments, example.moment) != metric.moments.end())
            << example.metric;
    }
}

TEST(Examples, ShowVerticesAndFacetsThatExist) {
    const auto each_below = [](const std::vector<Index>& numbers, std::size_t count) {
        return std::ranges::all_of(numbers,
                                   [&](Index k) { return k >= 0 && static_cast<std::size_t>(k) < count; });
    };
    for (const Example& example : all_examples()) {
        const SurfaceMesh& rest = example.organ.rest;
        EXPECT_FALSE(example.panels.empty());
        EXPECT_FALSE(example.caption.empty());
        for (const Panel& panel : example.panels) {
            EXPECT_EQ(panel.positions.size(), rest.positions.size()) << example.metric;
            EXPECT_TRUE(panel.from.empty() || panel.from.size() == rest.positions.size()) << example.metric;
            EXPECT_TRUE(each_below(panel.marks.vertices, rest.positions.size())) << example.metric;
            EXPECT_TRUE(each_below(panel.marks.facets, rest.facets.size())) << example.metric;
        }
    }
}

/// The value of another metric of the same step at the same moment.
double also(const std::string& example, const std::string& metric) {
    Example step = find_example(example);
    step.metric = metric;
    return judge_example(step).value;
}

TEST(Examples, SayOfOtherMetricsWhatIsTrue) {
    for (const std::string blind : {"facets_crossing", "tool_points_inside", "tool_volume_inside"}) {
        EXPECT_EQ(also(blind, "vertices_inside"), 0) << blind;
        EXPECT_EQ(also(blind, "depth_max"), 0) << blind;
    }
    EXPECT_EQ(also("tool_points_inside", "facets_crossing"), 0) << "swallowed whole";
    EXPECT_NEAR(also("tool_points_inside", "tool_volume_inside"), 4 * 4 * 12, 1e-9);
    EXPECT_EQ(also("tunnelled", "collided_vertices"), 0) << "never detected";
    EXPECT_EQ(also("tool_crossings", "vertices_inside"), 0) << "nothing to complain of";
    EXPECT_EQ(also("gap_mean", "vertices_inside"), 0) << "cheating on penetration";
}

TEST(Examples, AreFoundByName) {
    EXPECT_EQ(find_example("drag").metric, "drag");
    EXPECT_THROW(find_example("drags"), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
