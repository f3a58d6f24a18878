#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/sweep/sweep.h"
#include "strategies/registry.h"

namespace trocar {

/// What a run asks of each of its cases beside its inputs. None of it changes what happens in a case.
struct CaseOptions {
    bool replay = false;
    std::vector<const Metric*> metrics = choose_metrics("all");
    int same_state = 0;                     ///< states of the case to hand to other strategies
    std::vector<StrategyChoice> answering;  ///< … which are these
    std::uint64_t not_asked = 0;  ///< of `answering`, a bit each: asking them ended the process before
    /// Is told which of `answering` is about to be asked, and when none is any more; may be empty.
    std::function<void(std::optional<std::uint64_t>)> asking = nullptr;
    /// How a strategy is made, the case's own and those that answer.
    std::function<std::unique_ptr<Strategy>(const StrategyChoice&)> make = [](const StrategyChoice& choice) {
        return make_strategy(choice.name, choice.options);
    };
    std::int64_t earlier_attempts = 0;  ///< `attempts` of the result that an earlier run left of the case
};

/// The names of the metrics, with commas between them.
std::string metric_names(const std::vector<const Metric*>& metrics);

}  // namespace trocar
