#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric facets_crossing() {
    return {.name = "facets_crossing",
            .units = "1",
            .definition = "organ facets that cross the tool's surface, by exact orientation signs",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return static_cast<double>(step.at(moment).crossing_facets().size());
            }};
}

}  // namespace trocar::metrics
