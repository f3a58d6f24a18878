#include "experiments/run/run_case.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <new>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/metrics/judge/judge.h"
#include "experiments/run/case_series.h"
#include "experiments/run/figures.h"
#include "experiments/run/replay_recorder.h"
#include "experiments/run/ring_shifts.h"
#include "experiments/run/same_state.h"
#include "experiments/scenes/scene.h"
#include "strategies/registry.h"

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
    CaseSeries series;
    std::vector<Measured> at_end;  ///< of end_readings(the metrics asked for)
    std::vector<std::vector<Cell>> states;
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

JudgeSettings judge_settings(const CaseInputs& inputs, const PreparedScene& scene,
                             const CaseOptions& options) {
    return {.metrics = options.metrics,
            .region = region_of(*inputs.organ.judged, scene.region),
            .every = sampled_every(inputs.cycle.rate)};
}

Outcome run_steps(const CaseInputs& inputs, const PreparedScene& scene, Strategy& strategy,
                  const CaseOptions& options, Gathered& gathered, const std::stop_token& stop) {
    const Organ& organ = *inputs.organ.organ;
    const double limit = diverged_diagonals * bounding_box(organ.rest.positions).size().norm();
    Cycle cycle(organ, *inputs.tool.tool, scene.start, inputs.cycle, inputs.springs);
    Judge judge({*inputs.organ.judged, *inputs.tool.judged, cycle.positions(), cycle.tool().pose()},
                judge_settings(inputs, scene, options));
    if (gathered.replay) record_start(*gathered.replay, scene.start.tool);
    StateSampler sampler(inputs.case_id, options.same_state);
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy.handle(contact, response);
    };
    RingShifts shifts(organ);
    const AskShifted ask = [&] {
        Contact contact = cycle.contact();
        contact.positions = judge.step().at(Moment::before).positions();  // handling has moved the cycle's
        return shifts.ask(strategy, find_strategy(inputs.strategy.name).description, contact);
    };
    for (std::size_t step = 0; step < scene.poses.size(); ++step) {
        if (stop.stop_requested()) return {.status = CaseStatus::complete, .reason = {}, .stopped = true};
        cycle.move(scene.poses[step]);
        cycle.detect();
        judge.before(cycle.positions(), cycle.tool().pose());
        if (gathered.replay) record_detected(*gathered.replay, cycle);
        cycle.handle(handler);
        judge.handled(cycle.positions(), cycle.response().fallbacks, ask);
        if (gathered.replay) record_handled(*gathered.replay, cycle);
        if (scene.window[step] && !cycle.detected().collided.empty()) {
            sampler.offer(step, cycle, judge.step());
        }
        cycle.deform();
        if (const std::string reason = divergence(organ, cycle.positions(), limit); !reason.empty()) {
            return {.status = CaseStatus::diverged, .reason = fmt::format("step {}: {}", step, reason)};
        }
        judge.deformed(cycle.positions());
        if (gathered.replay) record_deformed(*gathered.replay, cycle);
        append_step(gathered.series, judge.values(), cycle.times(), scene.window[step]);
    }
    gathered.at_end = judge.values_at_end();
    gathered.states = compare_on(std::move(sampler).kept(), options, inputs.strategy.label, inputs.cycle);
    return {};
}

/// Runs the scene; turns whatever is thrown into a status.
Outcome run_contained(const CaseInputs& inputs, const SceneSource& scene_of, Strategy& strategy,
                      const CaseOptions& options, Gathered& gathered, const std::stop_token& stop) {
    const auto failed = [&](std::string_view reason) {
        return Outcome{.status = CaseStatus::failed,
                       .reason = fmt::format("step {}: {}", gathered.series.steps(), reason)};
    };
    try {
        const std::shared_ptr<const PreparedScene> scene = scene_of(inputs);
        gathered.window = scene->window;
        return run_steps(inputs, *scene, strategy, options, gathered, stop);
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
        {"edge_stiffness", "g/s²", "stiffness of the spring along each edge", inputs.springs.edge_stiffness},
        {"rest_stiffness", "g/(s²·mm²)", "stiffness of the springs to the rest shape, per area",
         inputs.springs.rest_stiffness},
        {"release", "", "when a handled vertex is free again", release_name(inputs.cycle.release)},
        {"fractions", "1", "parts that each motion is cut into", std::int64_t{1}},
        {"seed", "1", "seed of the scene's placement", whole(inputs.seed)},
        {"sweep_number", "1", "number of the case in the sweep's list, from 1", inputs.sweep_number},
    };
}

std::vector<Cell> outcome_cells(const Outcome& outcome, const CaseOptions& options, double wall_s) {
    return {
        {"status", "", "how the case ended", std::string(status_name(outcome.status))},
        {"reason", "", "why, where it did not complete", outcome.reason},
        {"attempts", "1", "how often the case was started, but for starts that the end of their run cut off",
         options.earlier_attempts + 1},
        {"wall_s", "s", "wall clock of the whole case, judging included", wall_s},
    };
}

/// How the case was judged.
std::vector<Cell> judging_cells(const CaseInputs& inputs, const CaseOptions& options,
                                const Gathered& gathered) {
    const auto counted = std::ranges::count(gathered.window, true);
    return {
        {"metrics", "", "metrics that were taken", metric_names(options.metrics)},
        {"judged_rate", "Hz", "how often they were taken",
         inputs.cycle.rate / sampled_every(inputs.cycle.rate)},
        {"same_state", "1", "states to hand to every strategy",
         static_cast<std::int64_t>(options.same_state)},
        {"window_steps", "1", "steps over which figures are taken", static_cast<std::int64_t>(counted)},
        {"missing", "", "steps of them without a value: for each series and reason how many, as JSON",
         missing_in_window(gathered.series)},
    };
}

/// One for each of end_readings(metrics), whether the case came so far or not.
std::vector<Cell> end_figures(const CaseOptions& options, const std::vector<Measured>& values) {
    const std::vector<Reading> readings = end_readings(options.metrics);
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const Metric& metric = *readings[k].metric;
        cells.push_back({metric.name + "_final", metric.units, reading_long_name(readings[k]),
                         values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[k].value});
    }
    return cells;
}

std::vector<Cell> figure_cells(const CaseOptions& options, const Gathered& gathered, CaseStatus status) {
    std::vector<Cell> figures = metric_figures(gathered.series.metrics, gathered.window);
    std::ranges::move(end_figures(options, gathered.at_end), std::back_inserter(figures));
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
    note_missing(gathered.series);
    record.series = std::move(gathered.series.metrics);
    std::ranges::move(gathered.series.times, std::back_inserter(record.series));
    record.series.push_back(std::move(gathered.series.window));
    record.states = std::move(gathered.states);
    record.replay = std::move(gathered.replay);
    if (record.replay) record.replay->steps.resize(steps);
}

}  // namespace

std::string metric_names(const std::vector<const Metric*>& metrics) {
    std::vector<std::string_view> names;
    for (const Metric* metric : metrics) names.push_back(metric->name);
    return fmt::format("{}", fmt::join(names, ","));
}

namespace {

Gathered nothing_yet(const CaseInputs& inputs, const CaseOptions& options) {
    Gathered gathered{
        .window = {}, .series = empty_series(options.metrics), .at_end = {}, .states = {}, .replay = {}};
    if (options.replay) gathered.replay = empty_replay(*inputs.organ.organ, *inputs.tool.tool);
    return gathered;
}

CaseRecord record_of(const CaseInputs& inputs, const CaseOptions& options, const Outcome& outcome,
                     Gathered&& gathered, double wall_s) {
    CaseRecord record;
    record.case_id = inputs.case_id;
    record.cells = identifying_cells(inputs);
    std::ranges::move(outcome_cells(outcome, options, wall_s), std::back_inserter(record.cells));
    std::ranges::move(judging_cells(inputs, options, gathered), std::back_inserter(record.cells));
    std::ranges::move(figure_cells(options, gathered, outcome.status), std::back_inserter(record.cells));
    add_steps(record, std::move(gathered), inputs.cycle.dt());
    return record;
}

}  // namespace

std::optional<CaseRecord> run_case(const CaseInputs& inputs, const SceneSource& scene_of, Strategy& strategy,
                                   const CaseOptions& options, const std::stop_token& stop) {
    const auto started = Clock::now();
    Gathered gathered = nothing_yet(inputs, options);
    const Outcome outcome = run_contained(inputs, scene_of, strategy, options, gathered, stop);
    if (outcome.stopped) return std::nullopt;
    const std::chrono::duration<double> wall = Clock::now() - started;
    return record_of(inputs, options, outcome, std::move(gathered), wall.count());
}

CaseRecord lost_case(const CaseInputs& inputs, const CaseOptions& options, CaseStatus status,
                     const std::string& reason, double wall_s) {
    return record_of(inputs, options, {.status = status, .reason = reason, .stopped = false},
                     nothing_yet(inputs, options), wall_s);
}

}  // namespace trocar
