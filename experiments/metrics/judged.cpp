#include "experiments/metrics/judged.h"

#include <algorithm>

#include "common/geometry/flat_edges.h"
#include "common/geometry/predicates.h"

namespace trocar {
namespace {

Box box_of(const Corners& corners) { return bounding_box(corners); }

}  // namespace

ToolJudge::ToolJudge(const Organ& organ, const Tool& tool)
    : organ_(organ),
      tool_mesh_(tool.mesh),
      tool_(tool.mesh),
      tool_box_(bounding_box(tool.mesh.positions)),
      flat_edges_(flat_edges(tool.mesh, Adjacency(tool.mesh.positions.size(), tool.mesh.facets))) {
    for (const auto& [a, b, c] : tool_mesh_.facets) {
        const auto& p = tool_mesh_.positions;
        tool_facets_.push_back({p[a], p[b], p[c]});
        tool_facet_boxes_.push_back(box_of(tool_facets_.back()));
    }
}

bool ToolJudge::crosses(const Corners& organ_facet) const {
    const Box box = box_of(organ_facet);
    if (!box.overlaps(tool_box_)) return false;
    for (std::size_t k = 0; k < tool_facets_.size(); ++k) {
        if (box.overlaps(tool_facet_boxes_[k]) &&
            facets_cross(organ_facet, tool_facets_[k], flat_edges_[k])) {
            return true;
        }
    }
    return false;
}

JudgedMoment ToolJudge::look(std::span<const Vec3> positions, const Pose& pose) const {
    JudgedMoment seen{.positions = {positions.begin(), positions.end()}, .inside = {}, .depths = {}};
    std::vector<Vec3> in_tool;
    in_tool.reserve(positions.size());
    for (const Vec3& position : positions) in_tool.push_back(judged_position(pose, position));
    for (std::size_t vertex = 0; vertex < in_tool.size(); ++vertex) {
        if (!tool_box_.contains(in_tool[vertex]) || !tool_.contains(in_tool[vertex])) continue;
        seen.inside.push_back(static_cast<Index>(vertex));
        seen.depths.push_back(tool_.distance(in_tool[vertex]));
    }
    for (const auto& [a, b, c] : organ_.rest.facets) {
        if (crosses({in_tool[a], in_tool[b], in_tool[c]})) ++seen.facets_crossing;
    }
    return seen;
}

}  // namespace trocar
