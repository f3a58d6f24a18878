#include <cmath>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric strain() {
    return {.name = "strain",
            .units = "1",
            .definition =
                "root mean square of (length over length at rest - 1) over the edges near the tool's sweep",
            .better = "low",
            .moments = {Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (step.region.edges.empty()) return Missing::empty_region;
                const auto& positions = step.at(moment).positions();
                double sum = 0;
                for (const Index edge : step.region.edges) {
                    const auto& [a, b] = step.organ().edges()[edge];
                    const double ratio =
                        (positions[a] - positions[b]).norm() / step.organ().rest_lengths()[edge];
                    sum += (ratio - 1) * (ratio - 1);
                }
                return std::sqrt(sum / static_cast<double>(step.region.edges.size()));
            }};
}

}  // namespace trocar::metrics
