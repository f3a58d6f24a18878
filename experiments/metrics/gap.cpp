#include <vector>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/judge/summary.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

/// The distance to the tool's surface, mm, of every vertex that handling moved and that is outside now.
std::vector<double> gaps(const Judged& step, Moment moment) {
    const auto& before = step.at(Moment::before).positions();
    const auto& handled = step.at(Moment::handled).positions();
    const JudgedState& now = step.at(moment);
    std::vector<double> gaps;
    for (std::size_t vertex = 0; vertex < handled.size(); ++vertex) {
        if (handled[vertex] == before[vertex] || now.is_inside(static_cast<Index>(vertex))) continue;
        gaps.push_back(step.tool().surface().distance(now.in_tool()[vertex]));
    }
    return gaps;
}

}  // namespace

Metric gap_mean() {
    return {.name = "gap_mean",
            .units = "mm",
            .definition =
                "mean distance to the tool's surface of the vertices that handling moved and that are "
                "outside it: a method that throws far leaves a hole",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return mean_of(gaps(step, moment), Missing::no_vertex_moved);
            }};
}

Metric gap_max() {
    return {.name = "gap_max",
            .units = "mm",
            .definition =
                "largest distance to the tool's surface of a vertex that handling moved and that is "
                "outside it",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                return largest_of(gaps(step, moment), Missing::no_vertex_moved);
            }};
}

}  // namespace trocar::metrics
