// What a step of the simulation cycle costs, phase by phase, along the penetration scene. See README.md.

#include <algorithm>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "common/cycle/cycle.h"
#include "common/geometry/organ_shapes.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/prepared_scene.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

constexpr double speed = 100;  // mm/s

/// Sums over the steps in which the tool meets the organ.
struct Sums {
    double steps = 0;
    double move = 0, detect = 0, handle = 0, deform = 0;  // ns
    double collided = 0, most_collided = 0;

    void add(const Cycle& cycle) {
        const PhaseTimes& times = cycle.times();
        steps += 1;
        move += static_cast<double>(times.move);
        detect += static_cast<double>(times.detect);
        handle += static_cast<double>(times.handle);
        deform += static_cast<double>(times.deform);
        const auto count = static_cast<double>(cycle.detected().collided.size());
        collided += count;
        most_collided = std::max(most_collided, count);
    }
    [[nodiscard]] double time() const { return move + detect + handle + deform; }
};

void run_scene(const Organ& organ, const Tool& tool, const PreparedScene& scene, Strategy& strategy,
               Sums& sums) {
    Cycle cycle(organ, tool, scene.start, CycleSettings{}, SpringSettings{});
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy.handle(contact, response);
    };
    for (std::size_t step = 0; step < scene.poses.size(); ++step) {
        cycle.move(scene.poses[step]);
        cycle.detect();
        cycle.handle(handler);
        cycle.deform();
        if (scene.window[step]) sums.add(cycle);
    }
}

void time_cycle(benchmark::State& state, const std::string& strategy_name, const std::string& organ_name) {
    constexpr double nanoseconds_per_microsecond = 1e3, nanoseconds_per_second = 1e9;
    const Organ organ = make_organ_by_formula(organ_name);
    const SurfaceQueries queries(organ.rest);
    const Tool tool = make_tool_by_formula("prism-12");
    const PreparedScene scene = prepare_scene(find_scene("penetration"), {.organ = organ,
                                                                          .organ_queries = queries,
                                                                          .tool = tool,
                                                                          .speed = speed,
                                                                          .dt = CycleSettings{}.dt(),
                                                                          .seed = 1});
    Sums all;
    for (auto _ : state) {
        const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
        const Sums before = all;
        run_scene(organ, tool, scene, *strategy, all);
        const double step_time = (all.time() - before.time()) / (all.steps - before.steps);
        state.SetIterationTime(step_time / nanoseconds_per_second);
    }
    const auto mean_us = [&](double sum) { return sum / all.steps / nanoseconds_per_microsecond; };
    state.counters["move_us"] = mean_us(all.move);
    state.counters["detect_us"] = mean_us(all.detect);
    state.counters["handle_us"] = mean_us(all.handle);
    state.counters["deform_us"] = mean_us(all.deform);
    state.counters["collided"] = all.collided / all.steps;
    state.counters["collided_max"] = all.most_collided;
    state.counters["facets"] = static_cast<double>(organ.rest.facets.size());
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    for (const std::string strategy : {"nearest-face", "fuzzy-per-vertex"}) {
        for (const std::string organ : {"sphere@4mm", "sphere@2mm"}) {
            const std::string name = fmt::format("cycle/{}/{}", strategy, organ);
            benchmark::RegisterBenchmark(name.c_str(), trocar::time_cycle, strategy, organ)
                ->UseManualTime()
                ->Iterations(20)
                ->Unit(benchmark::kMicrosecond);
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
