#include <vector>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/judge/summary.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

/// How far handling moved each vertex that was inside the tool before it, mm.
std::vector<double> lengths(const Judged& step) {
    std::vector<double> lengths;
    for (const Index vertex : step.collided()) lengths.push_back(step.displacement(vertex).norm());
    return lengths;
}

}  // namespace

Metric displacement_mean() {
    return {.name = "displacement_mean",
            .units = "mm",
            .definition = "mean distance that handling moves the collided vertices",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) -> Measured {
                return mean_of(lengths(step), Missing::no_vertex_collided);
            }};
}

Metric displacement_max() {
    return {.name = "displacement_max",
            .units = "mm",
            .definition = "largest distance that handling moves a collided vertex",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) -> Measured {
                return largest_of(lengths(step), Missing::no_vertex_collided);
            }};
}

}  // namespace trocar::metrics
