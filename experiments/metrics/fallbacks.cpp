#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric fallbacks() {
    return {
        .name = "fallbacks",
        .units = "1",
        .definition = "directions that the strategy could not form, as it counts them itself",
        .better = "low",
        .moments = {Moment::handled},
        .value = [](const Judged& step, Moment) -> Measured { return static_cast<double>(step.fallbacks); }};
}

}  // namespace trocar::metrics
