#include <algorithm>
#include <limits>
#include <numeric>

#include "experiments/metrics/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

/// How far handling moved each vertex that was inside the tool before it, mm.
std::vector<double> displacements(const Judged& step) {
    const JudgedMoment &before = step.at(Moment::before), &after = step.at(Moment::handled);
    std::vector<double> lengths;
    for (const Index vertex : before.inside) {
        lengths.push_back((after.positions[vertex] - before.positions[vertex]).norm());
    }
    return lengths;
}

}  // namespace

Metric displacement_mean() {
    return {.name = "displacement_mean",
            .units = "mm",
            .definition = "mean distance that handling moves the collided vertices; none collided: no value",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) {
                const auto lengths = displacements(step);
                if (lengths.empty()) return std::numeric_limits<double>::quiet_NaN();
                return std::accumulate(lengths.begin(), lengths.end(), 0.0) /
                       static_cast<double>(lengths.size());
            }};
}

Metric displacement_max() {
    return {.name = "displacement_max",
            .units = "mm",
            .definition = "largest distance that handling moves a collided vertex; none collided: no value",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) {
                const auto lengths = displacements(step);
                return lengths.empty() ? std::numeric_limits<double>::quiet_NaN() : std::ranges::max(lengths);
            }};
}

}  // namespace trocar::metrics
