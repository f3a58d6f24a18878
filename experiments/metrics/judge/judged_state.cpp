#include "experiments/metrics/judge/judged_state.h"

#include <algorithm>

namespace trocar {

JudgedState::JudgedState(const JudgedOrgan& organ, const JudgedTool& tool, std::span<const Vec3> positions,
                         const Pose& pose)
    : organ_(&organ), tool_(&tool), positions_(positions.begin(), positions.end()), pose_(pose) {}

const std::vector<Vec3>& JudgedState::in_tool() const& {
    if (in_tool_) return *in_tool_;
    in_tool_.emplace();
    in_tool_->reserve(positions_.size());
    for (const Vec3& position : positions_) in_tool_->push_back(judged_position(pose_, position));
    return *in_tool_;
}

const std::vector<Index>& JudgedState::inside() const& {
    if (inside_) return *inside_;
    inside_.emplace();
    is_inside_.assign(positions_.size(), false);
    for (std::size_t vertex = 0; vertex < positions_.size(); ++vertex) {
        if (!tool_->contains(in_tool()[vertex])) continue;
        inside_->push_back(static_cast<Index>(vertex));
        is_inside_[vertex] = true;
    }
    return *inside_;
}

const std::vector<double>& JudgedState::depths() const& {
    if (depths_) return *depths_;
    depths_.emplace();
    for (const Index vertex : inside()) depths_->push_back(tool_->surface().distance(in_tool()[vertex]));
    return *depths_;
}

bool JudgedState::is_inside(Index vertex) const {
    if (!inside_) static_cast<void>(inside());
    return is_inside_[vertex];
}

const std::vector<Index>& JudgedState::crossing_facets() const& {
    if (crossing_facets_) return *crossing_facets_;
    crossing_facets_.emplace();
    const std::vector<Facet>& facets = organ_->facets();
    for (std::size_t facet = 0; facet < facets.size(); ++facet) {
        const auto& [a, b, c] = facets[facet];
        if (tool_->crossed_by({in_tool()[a], in_tool()[b], in_tool()[c]})) {
            crossing_facets_->push_back(static_cast<Index>(facet));
        }
    }
    return *crossing_facets_;
}

}  // namespace trocar
