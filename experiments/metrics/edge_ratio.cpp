#include <vector>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/judge/summary.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

/// Length over length at rest of every edge with a collided end.
std::vector<double> ratios(const Judged& step, Moment moment) {
    const auto& positions = step.at(moment).positions();
    const auto edges = step.organ().edges();
    std::vector<double> ratios;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const auto& [a, b] = edges[k];
        if (!step.collided(a) && !step.collided(b)) continue;
        ratios.push_back((positions[a] - positions[b]).norm() / step.organ().rest_lengths()[k]);
    }
    return ratios;
}

}  // namespace

Metric edge_ratio_mean() {
    return {.name = "edge_ratio_mean",
            .units = "1",
            .definition = "mean length over length at rest of the edges with a collided end: low is bunched",
            .better = "high",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return mean_of(ratios(step, moment), Missing::no_edge_collided);
            }};
}

Metric edge_ratio_min() {
    return {.name = "edge_ratio_min",
            .units = "1",
            .definition = "least length over length at rest of an edge with a collided end: low is bunched",
            .better = "high",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return least_of(ratios(step, moment), Missing::no_edge_collided);
            }};
}

}  // namespace trocar::metrics
