#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"
#include "experiments/metrics/tool_inside/volume_inside.h"

namespace trocar::metrics {

Metric tool_volume_inside() {
    return {.name = "tool_volume_inside",
            .units = "mm³",
            .definition = "volume of the part of the tool where the organ's winding number is at least 1",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .cost = Cost::high,
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (!step.organ().has_inside()) return Missing::open_organ;
                return volume_inside(step.at(moment));
            }};
}

}  // namespace trocar::metrics
