#pragma once

#include <string>
#include <vector>

#include "common/cycle/cycle.h"
#include "experiments/metrics/judge/judge.h"
#include "results/record.h"

namespace trocar {

/// What a case leaves per step.
struct CaseSeries {
    std::vector<Series> metrics;                ///< one for each of readings_of(the metrics asked for)
    std::vector<std::vector<Missing>> missing;  ///< of each of them, per step: why there is no value
    std::vector<Series> times;  ///< time_move, time_detect, time_handle, time_deform, time_cycle; ns
    Series window;              ///< 1 where the step counts, else 0

    [[nodiscard]] std::size_t steps() const { return window.values.size(); }
};

/// A series for each reading of these metrics, without values.
CaseSeries empty_series(const std::vector<const Metric*>& metrics);

/// Adds one step.
void append_step(CaseSeries& series, const std::vector<Measured>& values, const PhaseTimes& times,
                 bool in_window);

/// What a metric's value at a moment is, for people: its definition and when it is taken.
std::string reading_long_name(const Reading& reading);

/// Notes in each series why values of it are missing, as Series::missing has it.
void note_missing(CaseSeries& series);

/// For each series and reason the number of steps in the window, of those that were sampled, without a
/// value: JSON such as {"drag":{"no vertex collided":12}}. Empty where nothing is missing.
std::string missing_in_window(const CaseSeries& series);

}  // namespace trocar
