#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric jitter() {
    return {.name = "jitter",
            .units = "mm",
            .definition = "mean |x_k - 2 x_(k-1) + x_(k-2)| over the vertices near the tool's sweep",
            .better = "low",
            .moments = {Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (step.region.vertices.empty()) return Missing::empty_region;
                if (step.step_before.empty()) return Missing::too_early;
                // A step finds the organ where the one before left it.
                const auto &now = step.at(moment).positions(), &last = step.at(Moment::before).positions();
                double sum = 0;
                for (const Index vertex : step.region.vertices) {
                    sum += (now[vertex] - 2 * last[vertex] + step.step_before[vertex]).norm();
                }
                return sum / static_cast<double>(step.region.vertices.size());
            }};
}

}  // namespace trocar::metrics
