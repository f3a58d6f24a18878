// What a strategy takes for one collided vertex: tools convex and not. See README.md.

#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "common/cycle/cycle.h"
#include "strategies/registry.h"
#include "tests/benchmarks/bench_main.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/bench_tools.h"

namespace trocar {
namespace {

constexpr double edge = 0.6;    // mm: fine enough that a fast tool finds many vertices at once
constexpr int facets = 72'000;  // of a sphere 60 mm wide
constexpr double speed = 400;   // mm/s

/// The scene with that tool; the last one is kept.
const BenchScene& scene_with(const BenchTool& tool) {
    static std::string kept_name;
    static std::unique_ptr<const BenchScene> kept;
    if (kept_name != tool.name) {
        kept = std::make_unique<const BenchScene>(sphere_of(facets, edge), tool.make(), "penetration", speed);
        kept_name = tool.name;
    }
    return *kept;
}

/// Brings the cycle to the handling of its step `last`, counted from 0.
void run_to(Cycle& cycle, const PreparedScene& scene, Strategy& strategy, std::size_t last) {
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy.handle(contact, response);
    };
    for (std::size_t step = 0; step <= last; ++step) {
        cycle.move(scene.poses[step]);
        cycle.detect();
        if (step == last) return;
        cycle.handle(handler);
        cycle.deform();
    }
}

/// The step on the way in that finds most collided vertices. The way is long enough in five steps.
std::size_t fullest_step(const BenchScene& on, const std::string& strategy_name) {
    constexpr std::size_t steps = 5;
    std::size_t fullest = 0, most = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
        const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
        run_to(cycle, on.scene, *strategy, step);
        if (cycle.detected().collided.size() <= most) continue;
        most = cycle.detected().collided.size();
        fullest = step;
    }
    return fullest;
}

/// One iteration handles the same state of a real run once more.
void time_handling(benchmark::State& state, const BenchTool& tool, const std::string& strategy_name) {
    const BenchScene& on = scene_with(tool);
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
    const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
    run_to(cycle, on.scene, *strategy, fullest_step(on, strategy_name));
    const Contact contact = cycle.contact();
    Response response;
    for (auto _ : state) {
        response.clear();
        strategy->handle(contact, response);
        benchmark::DoNotOptimize(response.displacements.data());
    }
    const auto collided = static_cast<double>(contact.collided.size());
    state.counters["per_vertex_s"] =
        benchmark::Counter(collided * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["collided"] = collided;
    state.counters["tool_facets"] = static_cast<double>(on.tool.mesh.facets.size());
    state.counters["convex"] = on.tool.solid.convex() ? 1 : 0;
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    for (const trocar::BenchTool& tool : trocar::bench_tools) {
        for (const trocar::StrategyEntry& entry : trocar::all_strategies()) {
            const std::string& strategy = entry.description.name;
            const std::string name = fmt::format("handling/{}/{}", tool.name, strategy);
            benchmark::RegisterBenchmark(name.c_str(), trocar::time_handling, tool, strategy)
                ->MinTime(0.1)
                ->Repetitions(5)
                ->DisplayAggregatesOnly()
                ->Unit(benchmark::kMicrosecond);
        }
    }
    return trocar::run_benchmarks(argc, argv);
}
