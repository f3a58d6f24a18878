#include <cmath>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric recovery() {
    return {.name = "recovery",
            .units = "mm",
            .definition =
                "root mean square distance to rest of the vertices near the tool's sweep, one second "
                "after it has left",
            .better = "low",
            .moments = {Moment::end},
            .value = [](const Judged& step, Moment) -> Measured {
                if (step.region.vertices.empty()) return Missing::empty_region;
                const auto &last = step.at(Moment::deformed).positions(),
                           &rest = step.organ().rest().positions;
                double sum = 0;
                for (const Index vertex : step.region.vertices) {
                    sum += (last[vertex] - rest[vertex]).squaredNorm();
                }
                return std::sqrt(sum / static_cast<double>(step.region.vertices.size()));
            }};
}

}  // namespace trocar::metrics
