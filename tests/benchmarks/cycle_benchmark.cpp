// What a step of the simulation cycle costs, phase by phase, on organs of all sizes. See README.md.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "common/cycle/cycle.h"
#include "strategies/registry.h"
#include "tests/benchmarks/bandwidth.h"
#include "tests/benchmarks/bench_main.h"
#include "tests/benchmarks/bench_scene.h"

namespace trocar {
namespace {

constexpr double s = 1e-9;                              // of a nanosecond
constexpr BenchOrgan pivot_organ = bench_organs.at(2);  // of 30,000 facets
constexpr std::size_t pivot_steps = 2'000;

/// Of each step that counts: the time of each phase in s, the vertices in contact.
struct Samples {
    std::vector<double> move, detect, handle, deform, cycle, collided, held;
    std::vector<double> tool_moves;  // of the steps in which the tool moves: the cycle, s

    void add(const Cycle& at) {
        const PhaseTimes& times = at.times();
        move.push_back(static_cast<double>(times.move) * s);
        detect.push_back(static_cast<double>(times.detect) * s);
        handle.push_back(static_cast<double>(times.handle) * s);
        deform.push_back(static_cast<double>(times.deform) * s);
        cycle.push_back(static_cast<double>(times.cycle()) * s);
        if (tool_moved(at)) tool_moves.push_back(cycle.back());
        collided.push_back(static_cast<double>(at.detected().collided.size()));
        held.push_back(static_cast<double>(at.held().size()));
    }
};

void report(benchmark::State& state, const Samples& samples, const Organ& organ) {
    const auto figures = [&](const std::string& name, const std::vector<double>& times) {
        state.counters[name + "_mean_s"] = mean(times);
        state.counters[name + "_p50_s"] = percentile(times, 0.5);
        state.counters[name + "_p99_s"] = percentile(times, 0.99);
    };
    figures("cycle", samples.cycle);
    figures("move", samples.move);
    figures("detect", samples.detect);
    figures("handle", samples.handle);
    figures("deform", samples.deform);
    figures("tool_moves", samples.tool_moves);
    state.counters["handle_collided_s"] = mean(samples.handle) / mean(samples.collided);
    state.counters["steps"] = static_cast<double>(samples.cycle.size());
    state.counters["collided"] = mean(samples.collided);
    state.counters["collided_max"] = std::ranges::max(samples.collided);
    state.counters["held"] = mean(samples.held);
    state.counters["facets"] = static_cast<double>(organ.rest.facets.size());
}

/// How many vertices move by more than what counts as a difference, mean over the steps: what no simulation
/// could leave out.
double moving_vertices(const BenchScene& on, const std::string& strategy_name) {
    constexpr double difference = 1e-3;  // mm
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
    const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
    std::vector<Vec3> before;
    std::vector<double> counts;
    const Onlooker note = [&](const Cycle& at) {
        before.assign(at.positions().begin(), at.positions().end());
    };
    const Onlooker count = [&](const Cycle& at) {
        std::size_t moving = 0;
        for (std::size_t v = 0; v < before.size(); ++v) {
            moving += static_cast<std::size_t>((at.positions()[v] - before[v]).norm() > difference);
        }
        counts.push_back(static_cast<double>(moving));
    };
    run_scene(cycle, on.scene, *strategy, {.detected = note, .ended = count});
    return mean(counts);
}

void report_limit(benchmark::State& state, const BenchScene& on, const std::string& strategy_name) {
    static const double bandwidth = triad_bandwidth();
    const double moving = moving_vertices(on, strategy_name);
    const double bytes = least_bytes(moving, SpringSettings{}.substeps);
    state.counters["moving"] = moving;
    state.counters["least_B"] = bytes;
    state.counters["triad_B_per_s"] = bandwidth;
    state.counters["least_s"] = bytes / bandwidth;
    state.counters["mean_over_least"] = state.counters["cycle_mean_s"] * bandwidth / bytes;
}

/// One iteration is the scene once, from the organ at rest.
void time_penetration(benchmark::State& state, const std::string& strategy_name, const BenchOrgan& organ) {
    const BenchScene& on = scene_on(organ, "penetration");
    Samples all;
    for (auto _ : state) {
        Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
        const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
        Samples one;
        run_scene(cycle, on.scene, *strategy, {.ended = [&](const Cycle& at) {
                      one.add(at);
                      all.add(at);
                  }});
        state.SetIterationTime(percentile(one.cycle, 0.5));
    }
    report(state, all, on.organ);
    report_limit(state, on, strategy_name);
}

/// One iteration is the scene again and again, without a rest of the organ, until enough steps counted.
void time_pivot(benchmark::State& state, const std::string& strategy_name) {
    const BenchScene& on = scene_on(pivot_organ, "pivot");
    Samples samples;
    for (auto _ : state) {
        samples = {};
        Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
        const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
        while (samples.cycle.size() < pivot_steps) {
            run_scene(cycle, on.scene, *strategy, {.ended = [&](const Cycle& at) {
                          if (samples.cycle.size() < pivot_steps) samples.add(at);
                      }});
        }
        state.SetIterationTime(percentile(samples.cycle, 0.5));
    }
    report(state, samples, on.organ);
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    const std::vector<std::string> strategies = {"nearest-face", "fuzzy-per-vertex"};
    constexpr int repetitions = 3;
    for (const trocar::BenchOrgan& organ : trocar::bench_organs) {
        constexpr int large = 100'000;
        for (const std::string& strategy : strategies) {
            const std::string name = fmt::format("penetration/{}/{}", strategy, organ.name);
            benchmark::RegisterBenchmark(name.c_str(), trocar::time_penetration, strategy, organ)
                ->UseManualTime()
                ->Iterations(organ.facets < large ? 10 : 2)
                ->Repetitions(repetitions)
                ->DisplayAggregatesOnly()
                ->Unit(benchmark::kMicrosecond);
        }
    }
    for (const std::string& strategy : strategies) {
        benchmark::RegisterBenchmark(("pivot/" + strategy).c_str(), trocar::time_pivot, strategy)
            ->UseManualTime()
            ->Iterations(1)
            ->Repetitions(repetitions)
            ->DisplayAggregatesOnly()
            ->Unit(benchmark::kMicrosecond);
    }
    return trocar::run_benchmarks(argc, argv);
}
