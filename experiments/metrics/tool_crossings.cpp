#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric tool_crossings() {
    return {.name = "tool_crossings",
            .units = "1",
            .definition = "organ vertices put out of the tool on the side opposite to where they came in",
            .better = "low",
            .moments = {Moment::handled},
            .cost = Cost::high,
            .of_paths = true,
            .value = [](const Judged& step, Moment moment) -> Measured {
                return static_cast<double>(step.paths.value().crossings(step.at(moment)));
            }};
}

}  // namespace trocar::metrics
