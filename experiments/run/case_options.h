#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/sweep/sweep.h"

namespace trocar {

/// What a run asks of each of its cases beside its inputs. None of it changes what happens in a case.
struct CaseOptions {
    bool replay = false;
    std::vector<const Metric*> metrics = choose_metrics("all");
    int same_state = 0;                     ///< states of the case to hand to other strategies
    std::vector<StrategyChoice> answering;  ///< … which are these
    std::int64_t earlier_attempts = 0;      ///< `attempts` of the result that an earlier run left of the case
};

/// The names of the metrics, with commas between them.
std::string metric_names(const std::vector<const Metric*>& metrics);

}  // namespace trocar
