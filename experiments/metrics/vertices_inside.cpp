#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric vertices_inside() {
    return {.name = "vertices_inside",
            .units = "1",
            .definition = "organ vertices strictly inside the tool",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return static_cast<double>(step.at(moment).inside().size());
            }};
}

}  // namespace trocar::metrics
