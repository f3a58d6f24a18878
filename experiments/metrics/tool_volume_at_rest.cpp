#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"
#include "experiments/metrics/tool_inside/volume_inside.h"

namespace trocar::metrics {

Metric tool_volume_at_rest() {
    return {.name = "tool_volume_at_rest",
            .units = "mm³",
            .definition =
                "volume of the part of the tool that would be inside the organ if the organ were at rest",
            .better = "neither",
            .moments = {Moment::before},
            .cost = Cost::high,
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (!step.organ().has_inside()) return Missing::open_organ;
                const Pose& pose = step.at(moment).pose();
                return volume_inside({step.organ(), step.tool(), step.organ().rest().positions, pose});
            }};
}

}  // namespace trocar::metrics
