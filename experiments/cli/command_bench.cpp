#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <sys/resource.h>

#include "common/tool/tool_shapes.h"
#include "experiments/cli/bench_run.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/organ_argument.h"
#include "experiments/input_error.h"
#include "experiments/say.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "The tool goes straight in and out (the scene penetration), at one entry point after the other until\n"
    "there are enough steps. Steps count at which the tool meets the organ at rest; those of a first run,\n"
    "which warms up, do not. Everything runs in one thread, 30 steps a second of simulated time.\n"
    "A strategy meets a budget if at most one step in a hundred takes longer; the share that does is told.\n"
    "The times are of this machine, with what else it does; the command decides nothing by them.\n"
    "Exit codes: 0 done; 2 bad usage or input.\n"
    "Example:\n"
    "  trocar bench --organ liver.off --size 200 --strategy fuzzy-per-vertex";

struct BenchOptions {
    std::string organ = "sphere@1.2mm";
    std::optional<double> size;
    std::string tool = "prism-12";
    std::vector<std::string> strategies;
    std::size_t steps = 300;
};

constexpr double second = 1e9;       // ns
constexpr double millisecond = 1e6;  // ns

struct Phase {
    const char* name;
    std::int64_t (*time)(const PhaseTimes&);
};
constexpr std::array phases = {
    Phase{"move", [](const PhaseTimes& times) { return times.move; }},
    Phase{"detect", [](const PhaseTimes& times) { return times.detect; }},
    Phase{"handle", [](const PhaseTimes& times) { return times.handle; }},
    Phase{"deform", [](const PhaseTimes& times) { return times.deform; }},
    Phase{"cycle", [](const PhaseTimes& times) { return times.cycle(); }},
};

struct Budget {
    const char* name;
    double time;  // ns
};
constexpr std::array budgets = {Budget{"1/30 s", second / 30}, Budget{"1/40 s", second / 40},
                                Budget{"1 ms", millisecond}};
constexpr double allowed_over = 0.01;  // of the steps

/// The least of the numbers, which ascend, that so many of a hundred do not exceed.
template <typename Number>
Number percentile(const std::vector<Number>& ascending, double hundredths) {
    const double rank = std::ceil(hundredths / 100 * static_cast<double>(ascending.size()));
    return ascending.at(static_cast<std::size_t>(std::max(rank, 1.0)) - 1);
}

std::vector<std::int64_t> ascending_times(const BenchTimes& times, const Phase& phase) {
    std::vector<std::int64_t> all;
    for (const PhaseTimes& step : times.steps) all.push_back(phase.time(step));
    std::ranges::sort(all);
    return all;
}

std::string verdict(const std::vector<std::int64_t>& ascending, const Budget& budget) {
    const auto over = std::ranges::count_if(
        ascending, [&](std::int64_t time) { return static_cast<double>(time) > budget.time; });
    const double share = static_cast<double>(over) / static_cast<double>(ascending.size());
    return fmt::format("{}: {}, {:.3g} % of steps over", budget.name,
                       share <= allowed_over ? "meets" : "misses", 100 * share);
}

void print_strategy(const std::string& name, BenchTimes times) {
    std::ranges::sort(times.collided);
    fmt::print("\n{}; collided vertices of a step: {} (median), {} (most)\n", name,
               percentile(times.collided, 50), times.collided.back());
    fmt::print("  {:<8}{:>10}{:>10}{:>10}{:>10}\n", "ms", "p50", "p95", "p99", "max");
    std::vector<std::int64_t> ascending;
    for (const Phase& phase : phases) {
        ascending = ascending_times(times, phase);
        fmt::print("  {:<8}", phase.name);
        for (const double hundredths : {50, 95, 99, 100}) {
            fmt::print("{:>10.4f}", static_cast<double>(percentile(ascending, hundredths)) / millisecond);
        }
        fmt::print("\n");
    }
    // The last phase is the whole cycle.
    std::string verdicts;
    for (const Budget& budget : budgets) {
        verdicts += (verdicts.empty() ? "" : "; ") + verdict(ascending, budget);
    }
    fmt::print("  {}\n", verdicts);
}

/// The most memory that this process has held at once, MB.
double peak_memory() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<double>(use.ru_maxrss) * 1024 / 1e6;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> chosen_strategies(const BenchOptions& options) {
    std::vector<std::string> names;
    for (const std::string& name : options.strategies) names.push_back(find_strategy(name).description.name);
    if (!names.empty()) return names;
    for (const StrategyEntry& entry : all_strategies()) names.push_back(entry.description.name);
    return names;
}

/// Reads the organ and prepares a cycle on it, and says what that took.
Organ start_up(const BenchOptions& options, const Tool& tool) {
    const auto start = std::chrono::steady_clock::now();
    OrganInput input = organ_of_argument(options.organ, options.size);
    const double read = seconds_since(start);
    for (const Finding& finding : input.findings) {
        say("organ \"{}\": {}\n", input.organ.name, describe(finding));
    }
    const Cycle cycle(input.organ, tool, start_at_rest(input.organ, Pose{}), CycleSettings{},
                      SpringSettings{});
    fmt::print("organ {}: {} vertices, {} facets\n", input.organ.name, input.organ.rest.positions.size(),
               input.organ.rest.facets.size());
    fmt::print(
        "start-up: {:.2f} s, of which {:.2f} s to read or make the organ; peak memory so far {:.0f} MB\n",
        seconds_since(start), read, peak_memory());
    return std::move(input.organ);
}

int bench(const BenchOptions& options) {
    const std::vector<std::string> strategies = chosen_strategies(options);
    const Tool tool = make_tool_by_formula(options.tool);
    const Organ organ = start_up(options, tool);
    try {
        const BenchScenes scenes = bench_scenes(organ, tool, options.steps);
        fmt::print("tool {}, straight in and out at {} mm/s\n", tool.name, bench_speed);
        fmt::print("{} steps count (entry points: {}), after a run to warm up; one thread\n", scenes.steps,
                   scenes.runs.size());
        for (const std::string& name : strategies) {
            print_strategy(name, time_strategy(organ, tool, scenes, name));
        }
    } catch (const PlacementError& error) {
        throw InputError(error.what());
    }
    fmt::print("\npeak memory {:.0f} MB, with what placed the tool on the organ\n", peak_memory());
    return ExitCode::done;
}

}  // namespace

void add_bench(CLI::App& app, Program& program) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* command =
        app.add_subcommand("bench", "Time each phase of a step on this machine, strategy by strategy");
    command->footer(footer);
    command->add_option("--organ", options->organ, "mesh file, or a formula (trocar list organs)")
        ->capture_default_str();
    command->add_option("--size", options->size, "longest side of a mesh file, mm; else numbers count as mm");
    command->add_option("--tool", options->tool, "name of a tool (trocar list tools)")->capture_default_str();
    command
        ->add_option("--strategy", options->strategies,
                     "time this one only; may be given several times (trocar list strategies)")
        ->allow_extra_args(false);
    command->add_option("--steps", options->steps, "at least so many steps of each strategy count")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->callback([options, &program] { program.exit_code = bench(*options); });
}

}  // namespace trocar
