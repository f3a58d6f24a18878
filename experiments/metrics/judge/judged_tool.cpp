#include "experiments/metrics/judge/judged_tool.h"

#include <algorithm>

#include "common/geometry/flat_edges.h"
#include "experiments/metrics/tool_inside/tool_points.h"

namespace trocar {

JudgedTool::JudgedTool(const Tool& tool)
    : tool_(tool),
      surface_(tool.mesh),
      box_(bounding_box(tool.mesh.positions)),
      flat_edges_(flat_edges(tool.mesh, Adjacency(tool.mesh.positions.size(), tool.mesh.facets))),
      winding_integral_(tool.mesh),
      rays_(tool.mesh),
      points_(tool_points(tool.mesh)) {}

bool JudgedTool::crossed_by(const Corners& facet) const {
    const Box box = bounding_box(facet);
    if (!box.overlaps(box_)) return false;
    return std::ranges::any_of(surface_.facets_near(box), [&](Index k) {
        const auto& [a, b, c] = mesh().facets[k];
        const auto& p = mesh().positions;
        return facets_cross(facet, {p[a], p[b], p[c]}, flat_edges_[k]);
    });
}

}  // namespace trocar
