#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"
#include "experiments/metrics/tool_inside/organ_over_tool.h"

namespace trocar::metrics {
namespace {

/// Right but for rounding where the organ's surface does not cross itself within the tool. Elsewhere the rays
/// correct what its winding number counts too much; where there is more to correct than there is inside, they
/// alone do better.
double volume_inside(const JudgedState& state) {
    constexpr double rounding = 1e-12;  // of the tool's box
    const std::vector<Corners> organ = organ_over_tool(state);
    const SeenVolumes seen = state.tool().rays().look(organ);
    if (seen.ambiguous > seen.inside) return seen.inside;
    const double volume = state.tool().winding_integral().over_tool(organ) - seen.excess;
    return volume > rounding * state.tool().box().size().prod() ? volume : 0;
}

}  // namespace

Metric tool_volume_inside() {
    return {.name = "tool_volume_inside",
            .units = "mm³",
            .definition = "volume of the part of the tool where the organ's winding number is at least 1",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .cost = Cost::high,
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (!step.organ().has_inside()) return Missing::open_organ;
                return volume_inside(step.at(moment));
            }};
}

}  // namespace trocar::metrics
