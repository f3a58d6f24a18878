#include "experiments/run/same_state.h"

#include <algorithm>
#include <charconv>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "common/cycle/check_response.h"
#include "experiments/run/case_series.h"
#include "experiments/run/ring_shifts.h"
#include "experiments/scenes/draws.h"
#include "experiments/sweep/cases.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

constexpr std::size_t most_parts = 64;  // of a task, that can be left out
constexpr const char* ended_process =
    "it ended the process when it was asked, or took more than a case may take";

/// The first 64 bits of a hash.
std::uint64_t leading_bits(const std::string& hash) {
    std::uint64_t bits = 0;
    std::from_chars(hash.data(), hash.data() + std::min<std::size_t>(hash.size(), 16), bits, 16);
    return bits;
}

/// What a strategy is given in this state; views of it and of the tool.
Contact contact_of(const FoundState& state, const PlacedTool& tool, const CycleSettings& cycle) {
    const JudgedState& before = state.judged.at(Moment::before);
    return {.organ = before.organ().organ(),
            .positions = before.positions(),
            .velocities = state.velocities,
            .tool = tool,
            .motion = state.motion,
            .collided = state.detected.collided,
            .crossed = state.detected.crossed,
            .near_vertices = state.detected.near_vertices,
            .near_facets = state.detected.near_facets,
            .clearance = cycle.clearance,
            .dt = cycle.dt()};
}

/// Has the strategy handle the contact, and puts that in the place of how `judged` was handled. Throws what
/// the strategy throws, and what check_response throws.
void handle(const Contact& contact, Strategy& strategy, Judged& judged) {
    Response response;
    strategy.handle(contact, response);
    std::vector<Vec3> positions = judged.at(Moment::before).positions();
    ResponseCheck(positions.size()).check(response);
    for (const auto& [vertex, displacement] : response.displacements) positions[vertex] += displacement;
    judged.handled.emplace(judged.organ(), judged.tool(), positions, judged.at(Moment::before).pose());
    judged.fallbacks = response.fallbacks;
}

/// What the strategy makes of the state. Throws what `handle` throws.
Judged answer_of(const FoundState& state, const StrategyChoice& choice, const CaseOptions& options,
                 const std::string& own, const CycleSettings& cycle) {
    Judged judged = state.judged;
    const PlacedTool tool(judged.tool().tool(), judged.at(Moment::before).pose());
    const Contact contact = contact_of(state, tool, cycle);
    const auto strategy = options.make(choice);
    if (choice.label != own) handle(contact, *strategy, judged);
    // Also of the run's own: in a step that was not sampled it was not asked.
    if (need_shifts(options.metrics)) {
        RingShifts shifts(contact.organ);
        judged.shifted = shifts.ask(*strategy, find_strategy(choice.name).description, contact);
    }
    return judged;
}

/// Whether the strategy was not asked because that ended the process before.
bool is_left_out(std::size_t number, const CaseOptions& options) {
    return number < most_parts && (options.not_asked >> number & 1U) != 0;
}

void tell_asking(const CaseOptions& options, std::optional<std::size_t> number) {
    if (options.asking && (!number || *number < most_parts)) options.asking(number);
}

/// Of the strategy of that number in `answering`.
std::vector<Cell> row(const FoundState& state, std::size_t number, const CaseOptions& options,
                      const std::string& own, const CycleSettings& cycle) {
    const StrategyChoice& choice = options.answering[number];
    const std::vector<Reading> readings = handled_readings(options.metrics);
    std::vector<Measured> values(readings.size(), Missing::no_answer);
    std::string reason;
    try {
        if (is_left_out(number, options)) throw std::runtime_error(ended_process);
        tell_asking(options, choice.label == own ? std::nullopt : std::optional(number));
        values = values_of(readings, answer_of(state, choice, options, own, cycle));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        reason = error.what();
    } catch (...) {
        reason = "the strategy threw something that is no std::exception";
    }
    std::vector<Cell> cells{
        {"step", "1", "step of the run, from 0", static_cast<std::int64_t>(state.step)},
        {"strategy", "", "strategy that answered", choice.name},
        {"options", "", "its options, defaults included, as JSON", options_json(choice.options)},
        {"label", "", "its label in tables and figures", choice.label},
        {"reason", "", "why it gave no answer, where it did not", reason},
    };
    nlohmann::json missing = nlohmann::json::object();
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (values[k].missing == Missing::nothing) continue;
        missing[series_name(*readings[k].metric, readings[k].moment)] = missing_reason(values[k].missing);
    }
    cells.push_back(
        {"missing", "", "why values are missing, as JSON", missing.empty() ? "" : missing.dump()});
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto& [metric, moment] = readings[k];
        cells.push_back(
            {series_name(*metric, moment), metric->units, reading_long_name(readings[k]), values[k].value});
    }
    return cells;
}

}  // namespace

StateSampler::StateSampler(const std::string& case_id, int states)
    : seed_(leading_bits(case_id)), most_(static_cast<std::size_t>(states)) {}

void StateSampler::offer(std::size_t step, const Cycle& cycle, const Judged& judged) {
    if (most_ == 0) return;
    const std::uint64_t place =
        kept_.size() < most_
            ? kept_.size()
            : static_cast<std::uint64_t>(draw(seed_, offered_)[0] * static_cast<double>(offered_ + 1));
    ++offered_;
    if (place >= most_) return;
    if (place == kept_.size()) kept_.emplace_back();
    kept_[place] = std::make_unique<FoundState>(
        FoundState{.step = step,
                   .judged = judged,
                   .velocities = {cycle.velocities().begin(), cycle.velocities().end()},
                   .motion = cycle.motion(),
                   .detected = cycle.detected()});
}

std::vector<FoundState> StateSampler::kept() && {
    std::ranges::sort(kept_, {}, [](const auto& state) { return state->step; });
    std::vector<FoundState> states;
    states.reserve(kept_.size());
    for (auto& state : kept_) states.push_back(std::move(*state));
    return states;
}

std::vector<std::vector<Cell>> compare_on(const std::vector<FoundState>& states, const CaseOptions& options,
                                          const std::string& own, const CycleSettings& cycle) {
    std::vector<std::vector<Cell>> rows;
    for (const FoundState& state : states) {
        for (std::size_t k = 0; k < options.answering.size(); ++k)
            rows.push_back(row(state, k, options, own, cycle));
        tell_asking(options, std::nullopt);
    }
    return rows;
}

}  // namespace trocar
