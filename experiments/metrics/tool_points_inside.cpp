#include <algorithm>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"
#include "experiments/metrics/tool_inside/columns.h"
#include "experiments/metrics/tool_inside/organ_over_tool.h"

namespace trocar::metrics {
namespace {

/// Exact. A point on the organ's surface counts as moved a hair along the tool's axis, out of an organ that
/// its tip touches; a point on a facet that stands upright on that axis, sideways (see find_columns).
std::ptrdiff_t points_inside(const JudgedState& state) {
    const std::vector<Vec3>& points = state.tool().points();
    std::vector<int> winding(points.size(), 0);
    std::vector<ColumnHit> hits;
    for (const Corners& facet : organ_over_tool(state)) {
        find_columns(points, facet, hits);
        for (const auto& [column, sign] : hits) {
            const int side = orientation_sign(facet[0], facet[1], facet[2], points[column]);
            if (side * sign < 0) winding[column] += sign;
        }
    }
    return std::ranges::count_if(winding, [](int w) { return w >= 1; });
}

}  // namespace

Metric tool_points_inside() {
    return {.name = "tool_points_inside",
            .units = "1",
            .definition = "sample points of the tool's surface, one per mm², inside the organ",
            .better = "low",
            .moments = {Moment::handled, Moment::deformed},
            .cost = Cost::high,
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (!step.organ().has_inside()) return Missing::open_organ;
                return static_cast<double>(points_inside(step.at(moment)));
            }};
}

}  // namespace trocar::metrics
