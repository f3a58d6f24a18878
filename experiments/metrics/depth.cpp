#include <algorithm>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/judge/summary.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric depth_max() {
    return {
        .name = "depth_max",
        .units = "mm",
        .definition = "largest distance of a vertex inside the tool to its surface; 0 when none is inside",
        .better = "low",
        .moments = {Moment::handled, Moment::deformed},
        .value = [](const Judged& step, Moment moment) -> Measured {
            const auto& depths = step.at(moment).depths();
            return depths.empty() ? 0.0 : std::ranges::max(depths);
        }};
}

Metric depth_mean() {
    return {.name = "depth_mean",
            .units = "mm",
            .definition = "mean distance of the vertices inside the tool to its surface",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return mean_of(step.at(moment).depths(), Missing::no_vertex_inside);
            }};
}

}  // namespace trocar::metrics
