#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"
#include "experiments/metrics/self_crossing/self_intersections.h"

namespace trocar::metrics {

Metric self_crossings() {
    return {.name = "self_crossings",
            .units = "1",
            .definition = "pairs of organ facets that intersect each other and do not at rest",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .cost = Cost::high,
            .value = [](const Judged& step, Moment moment) -> Measured {
                const SelfIntersections& intersections = step.organ().self_intersections();
                return static_cast<double>(intersections.beyond_rest(step.at(moment).positions()).size());
            }};
}

}  // namespace trocar::metrics
