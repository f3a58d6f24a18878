// What judging a step costs, metric by metric, beside the step itself. See README.md.

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "common/cycle/cycle.h"
#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/metrics/judge/judge.h"
#include "strategies/registry.h"
#include "tests/benchmarks/bench_main.h"

namespace trocar {
namespace {

constexpr double depth = 12;   // of the tool's tip in the organ at rest, mm
constexpr double motion = 10;  // of the tool in each step, mm
constexpr double nanoseconds_per_second = 1e9;

/// A step of a case, as a judge is told of it.
struct Step {
    Pose tool;
    std::vector<Vec3> before, handled, deformed;
    std::int64_t time;  // of the cycle, ns
};

/// The tool stands clear of the organ's top and goes straight down, in two steps of which the second ends
/// `depth` deep; the organ is handled in both.
std::vector<Step> two_steps(const Organ& organ, const Tool& tool, Pose pose) {
    Cycle cycle(organ, tool, start_at_rest(organ, pose), CycleSettings{}, SpringSettings{});
    const std::unique_ptr<Strategy> strategy = make_strategy("fuzzy-per-vertex");
    std::vector<Step> steps;
    const auto look = [&] { return std::vector<Vec3>(cycle.positions().begin(), cycle.positions().end()); };
    for (int k = 0; k < 2; ++k) {
        pose.position.z() -= motion;
        Step step{.tool = pose, .before = look(), .handled = {}, .deformed = {}, .time = 0};
        cycle.move(pose);
        cycle.detect();
        cycle.handle(
            [&](const Contact& contact, Response& response) { strategy->handle(contact, response); });
        step.handled = look();
        cycle.deform();
        step.deformed = look();
        step.time = cycle.times().cycle();
        steps.push_back(std::move(step));
    }
    return steps;
}

void judge_step(Judge& judge, const Step& step) {
    judge.before(step.before, step.tool);
    judge.handled(step.handled, 0);
    judge.deformed(step.deformed);
    benchmark::DoNotOptimize(judge.values());
}

void time_metrics(benchmark::State& state, const std::string& choice, const std::string& organ_name) {
    const Organ organ = make_organ_by_formula(organ_name);
    const Tool tool = make_tool_by_formula("prism-12");
    const JudgedOrgan judged_organ(organ);
    const JudgedTool judged_tool(tool);
    const double top = bounding_box(organ.rest.positions).high.z();
    const Pose start{.rotation = Mat3::Identity(), .position = {0, 0, top - depth + 2 * motion}};
    const std::vector<Step> steps = two_steps(organ, tool, start);
    const Region region =
        region_of(judged_organ, vertices_near_sweep(organ, tool, start, std::vector{steps.back().tool}));
    std::int64_t cycle = steps.back().time;  // ns, the shortest of a few: one alone may have been held up
    for (int k = 0; k < 4; ++k) cycle = std::min(cycle, two_steps(organ, tool, start).back().time);
    double judged = 0;  // ns
    for (auto _ : state) {
        Judge judge({judged_organ, judged_tool, organ.rest.positions, start},
                    {.metrics = choose_metrics(choice), .region = region});
        judge_step(judge, steps.front());
        const auto begin = std::chrono::steady_clock::now();
        judge_step(judge, steps.back());
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        judged += took.count() * nanoseconds_per_second;
        state.SetIterationTime(took.count());
    }
    const auto iterations = static_cast<double>(state.iterations());
    state.counters["of_cycle"] = judged / iterations / static_cast<double>(cycle);
    state.counters["cycle_ms"] = static_cast<double>(cycle) / 1e6;
    state.counters["facets"] = static_cast<double>(organ.rest.facets.size());
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    std::vector<std::string> choices = {"all", "fast"};
    for (const trocar::Metric& metric : trocar::all_metrics()) choices.push_back(metric.name);
    for (const std::string organ : {"sphere@4mm", "sphere@1.75mm"}) {
        for (const std::string& choice : choices) {
            const std::string name = fmt::format("metrics/{}/{}", organ, choice);
            benchmark::RegisterBenchmark(name.c_str(), trocar::time_metrics, choice, organ)
                ->UseManualTime()
                ->Iterations(50)
                ->Unit(benchmark::kMillisecond);
        }
    }
    return trocar::run_benchmarks(argc, argv);
}
