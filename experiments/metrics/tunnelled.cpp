#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric tunnelled() {
    return {.name = "tunnelled",
            .units = "1",
            .definition = "organ vertices that went through the tool between two looks: never detected",
            .better = "low",
            .moments = {Moment::before},
            .cost = Cost::high,
            .of_paths = true,
            .value = [](const Judged& step, Moment) -> Measured {
                return static_cast<double>(step.paths.value().tunnelled().size());
            }};
}

}  // namespace trocar::metrics
