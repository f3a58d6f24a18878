#pragma once

#include <vector>

#include "common/cycle/cycle.h"
#include "experiments/metrics/metric.h"
#include "results/record.h"

namespace trocar {

/// What a case leaves per step.
struct CaseSeries {
    std::vector<Series> metrics;  ///< in the order of Judge::values()
    std::vector<Series> times;    ///< time_move, time_detect, time_handle, time_deform, time_cycle; ns
    Series window;                ///< 1 where the step counts, else 0

    [[nodiscard]] std::size_t steps() const { return window.values.size(); }
};

/// Every series of this build, without values.
CaseSeries empty_series();

/// Adds one step.
void append_step(CaseSeries& series, const std::vector<double>& metric_values, const PhaseTimes& times,
                 bool in_window);

}  // namespace trocar
