#include "experiments/run/run_case.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <new>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "experiments/metrics/metric.h"
#include "experiments/run/case_series.h"
#include "experiments/run/figures.h"
#include "experiments/run/replay_recorder.h"
#include "experiments/scenes/scene.h"

namespace trocar {
namespace {

using Clock = std::chrono::steady_clock;

// An organ whose vertex is this many bounding-box diagonals from its rest place has flown apart.
constexpr double diverged_diagonals = 10;

struct Outcome {
    CaseStatus status = CaseStatus::complete;
    std::string reason;
    bool stopped = false;
};

/// What a case gathers while it runs.
struct Gathered {
    std::vector<bool> window;
    CaseSeries series = empty_series();
    std::optional<Replay> replay;
};

/// Why the organ counts as flown apart; empty when it does not.
std::string divergence(const Organ& organ, std::span<const Vec3> positions, double limit) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!positions[i].allFinite()) return fmt::format("vertex {} has no finite position", i);
        const double distance = (positions[i] - organ.rest.positions[i]).norm();
        if (distance > limit) return fmt::format("vertex {} is {:.4g} mm from its rest place", i, distance);
    }
    return {};
}

Outcome run_steps(const CaseInputs& inputs, const PreparedScene& scene, Strategy& strategy,
                  Gathered& gathered, const std::stop_token& stop) {
    const Organ& organ = *inputs.organ.organ;
    const double limit = diverged_diagonals * bounding_box(organ.rest.positions).size().norm();
    Cycle cycle(organ, *inputs.tool.tool, scene.start, inputs.cycle, inputs.springs);
    Judge judge(organ, *inputs.tool.tool);
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy.handle(contact, response);
    };
    for (std::size_t step = 0; step < scene.poses.size(); ++step) {
        if (stop.stop_requested()) return {.status = CaseStatus::complete, .reason = {}, .stopped = true};
        cycle.move(scene.poses[step]);
        cycle.detect();
        judge.before(cycle);
        if (gathered.replay) record_detected(*gathered.replay, cycle);
        cycle.handle(handler);
        judge.handled(cycle);
        if (gathered.replay) record_handled(*gathered.replay, cycle);
        cycle.deform();
        if (const std::string reason = divergence(organ, cycle.positions(), limit); !reason.empty()) {
            return {.status = CaseStatus::diverged, .reason = fmt::format("step {}: {}", step, reason)};
        }
        judge.deformed(cycle);
        if (gathered.replay) record_deformed(*gathered.replay, cycle);
        append_step(gathered.series, judge.values(), cycle.times(), scene.window[step]);
    }
    return {};
}

/// Runs the scene; turns whatever is thrown into a status.
Outcome run_contained(const CaseInputs& inputs, const SceneSource& scene_of, Strategy& strategy,
                      Gathered& gathered, const std::stop_token& stop) {
    const auto failed = [&](std::string_view reason) {
        return Outcome{.status = CaseStatus::failed,
                       .reason = fmt::format("step {}: {}", gathered.series.steps(), reason)};
    };
    try {
        const std::shared_ptr<const PreparedScene> scene = scene_of(inputs);
        gathered.window = scene->window;
        return run_steps(inputs, *scene, strategy, gathered, stop);
    } catch (const PlacementError& error) {
        return {.status = CaseStatus::failed, .reason = error.what()};
    } catch (const std::bad_alloc&) {
        return {.status = CaseStatus::out_of_memory, .reason = "out of memory"};
    } catch (const std::exception& error) {
        return failed(error.what());
    } catch (...) {
        return failed("the strategy threw something that is no std::exception");
    }
}

std::vector<Cell> identifying_cells(const CaseInputs& inputs) {
    const auto whole = [](auto number) { return static_cast<std::int64_t>(number); };
    const StrategyChoice& strategy = inputs.strategy;
    return {
        {"strategy", "", "collision-handling strategy", strategy.name},
        {"options", "", "the strategy's options, defaults included, as JSON", options_json(strategy.options)},
        {"label", "", "the strategy's label in tables and figures", strategy.label},
        {"organ", "", "organ", inputs.organ.organ->name},
        {"organ_facets", "1", "facets of the organ", whole(inputs.organ.organ->rest.facets.size())},
        {"tool", "", "tool", inputs.tool.tool->name},
        {"scene", "", "scene", inputs.scene.name},
        {"speed", "mm/s", "speed of the tool", inputs.speed},
        {"rate", "Hz", "steps a second", inputs.cycle.rate},
        {"release", "", "when a handled vertex is free again", release_name(inputs.cycle.release)},
        {"fractions", "1", "parts that each motion is cut into", std::int64_t{1}},
        {"seed", "1", "seed of the scene's placement", whole(inputs.seed)},
    };
}

std::vector<Cell> outcome_cells(const Outcome& outcome, double wall_s) {
    return {
        {"status", "", "how the case ended", std::string(status_name(outcome.status))},
        {"reason", "", "why, where it did not complete", outcome.reason},
        {"attempts", "1", "how often the case was started", std::int64_t{1}},
        {"wall_s", "s", "wall clock of the whole case, judging included", wall_s},
    };
}

std::vector<Cell> figure_cells(const Gathered& gathered, CaseStatus status) {
    std::vector<Cell> figures = metric_figures(gathered.series.metrics, gathered.window);
    std::ranges::move(time_figures(gathered.series.times, gathered.window), std::back_inserter(figures));
    if (status != CaseStatus::complete) clear_figures(figures);
    return figures;
}

/// Moves what was gathered per step into the record. A replay may hold one step more than the series: the one
/// in which the case ended.
void add_steps(CaseRecord& record, Gathered&& gathered, double dt) {
    const std::size_t steps = gathered.series.steps();
    for (std::size_t step = 0; step < steps; ++step)
        record.time.push_back(static_cast<double>(step + 1) * dt);
    record.series = std::move(gathered.series.metrics);
    std::ranges::move(gathered.series.times, std::back_inserter(record.series));
    record.series.push_back(std::move(gathered.series.window));
    record.replay = std::move(gathered.replay);
    if (record.replay) record.replay->steps.resize(steps);
}

}  // namespace

std::optional<CaseRecord> run_case(const CaseInputs& inputs, const SceneSource& scene_of, Strategy& strategy,
                                   bool with_replay, const std::stop_token& stop) {
    const auto started = Clock::now();
    Gathered gathered;
    if (with_replay) gathered.replay = empty_replay(*inputs.organ.organ, *inputs.tool.tool);
    const Outcome outcome = run_contained(inputs, scene_of, strategy, gathered, stop);
    if (outcome.stopped) return std::nullopt;
    const std::chrono::duration<double> wall = Clock::now() - started;

    CaseRecord record;
    record.case_id = inputs.case_id;
    record.cells = identifying_cells(inputs);
    std::ranges::move(outcome_cells(outcome, wall.count()), std::back_inserter(record.cells));
    std::ranges::move(figure_cells(gathered, outcome.status), std::back_inserter(record.cells));
    add_steps(record, std::move(gathered), inputs.cycle.dt());
    return record;
}

}  // namespace trocar
