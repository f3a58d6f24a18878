#include <algorithm>
#include <numeric>

#include "experiments/metrics/judge/judged.h"
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
                const std::vector<double> all = lengths(step);
                if (all.empty()) return Missing::no_vertex_collided;
                return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
            }};
}

Metric displacement_max() {
    return {.name = "displacement_max",
            .units = "mm",
            .definition = "largest distance that handling moves a collided vertex",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) -> Measured {
                const std::vector<double> all = lengths(step);
                return all.empty() ? Measured(Missing::no_vertex_collided) : std::ranges::max(all);
            }};
}

}  // namespace trocar::metrics
