#include "tests/benchmarks/bench_scene.h"

#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

#include "strategies/registry.h"
#include "tests/benchmarks/bench_tools.h"

namespace trocar {
namespace {

TEST(Percentile, IsTheSampleThatTheShareReaches) {
    const std::vector<double> samples = {7, 1, 10, 4, 3, 2, 6, 9, 8, 5};
    EXPECT_EQ(percentile(samples, 0.5), 5);
    EXPECT_EQ(percentile(samples, 0.51), 6);
    EXPECT_EQ(percentile(samples, 0.99), 10);
    EXPECT_EQ(percentile(samples, 0), 1);
    EXPECT_EQ(percentile({3}, 0.99), 3);
    EXPECT_EQ(mean(samples), 5.5);
}

TEST(SphereOf, HasTheFacetsAndTheEdge) {
    for (const double edge : {1.0, 2.0}) {
        for (const int facets : {2'000, 30'000}) {
            const Organ organ = sphere_of(facets, edge);
            EXPECT_NEAR(static_cast<double>(organ.rest.facets.size()) / facets, 1, 0.06);
            double sum = 0;
            for (const auto& [a, b] : organ.adjacency.edges()) {
                sum += (organ.rest.positions[a] - organ.rest.positions[b]).norm();
            }
            EXPECT_NEAR(sum / static_cast<double>(organ.adjacency.edges().size()) / edge, 1, 0.05);
        }
    }
}

TEST(BenchTools, AreConvexOrNotAsTheirNamesSay) {
    for (const BenchTool& tool : bench_tools) {
        EXPECT_EQ(tool.make().solid.convex(), std::string_view(tool.name) == "prism-12") << tool.name;
    }
    const Tool hook = bench_tools.back().make();
    EXPECT_EQ(hook.mesh.facets.size(), 1052);
    EXPECT_NEAR(hook.solid.box().low.z(), 0, 0.5);
    EXPECT_FALSE(hook.solid.contains({0, 0, 8}));  // the middle of the bend
}

TEST(RunScene, LooksAtTheStepsOfTheWindow) {
    const BenchScene& on = scene_on(bench_organs.at(0), "penetration");
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
    const auto strategy = make_strategy("nearest-face");
    std::size_t detected = 0, ended = 0, moved = 0;
    run_scene(cycle, on.scene, *strategy,
              {.detected = [&](const Cycle&) { ++detected; },
               .ended =
                   [&](const Cycle& at) {
                       ++ended;
                       moved += tool_moved(at) ? 1 : 0;
                   }});
    const auto window = static_cast<std::size_t>(std::ranges::count(on.scene.window, true));
    EXPECT_EQ(detected, window);
    EXPECT_EQ(ended, window);
    EXPECT_EQ(window, 22);
    EXPECT_EQ(moved, 7);  // the tool is held still for half a second
    EXPECT_TRUE(on.scene.window[steps_that_count(on.scene) - 1]);
}

}  // namespace
}  // namespace trocar
