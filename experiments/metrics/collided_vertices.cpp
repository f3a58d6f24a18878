#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric collided_vertices() {
    return {.name = "collided_vertices",
            .units = "1",
            .definition = "organ vertices strictly inside the tool before handling",
            .better = "neither",
            .moments = {Moment::before},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return static_cast<double>(step.at(moment).inside().size());
            }};
}

}  // namespace trocar::metrics
