#include <algorithm>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric spread() {
    return {.name = "spread",
            .units = "1",
            .definition =
                "mean over edges with two collided ends of |d_a - d_b| / |x_a - x_b|, the difference of "
                "their displacements over their length before: low is coherent",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) -> Measured {
                const auto& before = step.at(Moment::before).positions();
                double sum = 0, edges = 0;
                for (const auto& [a, b] : step.organ().edges()) {
                    if (!step.collided(a) || !step.collided(b) || before[a] == before[b]) continue;
                    sum +=
                        (step.displacement(a) - step.displacement(b)).norm() / (before[a] - before[b]).norm();
                    ++edges;
                }
                return edges == 0 ? Measured(Missing::no_edge_collided) : sum / edges;
            }};
}

}  // namespace trocar::metrics
