#include "strategies/registry.h"

#include <algorithm>
#include <stdexcept>

#include "common/nearest_name.h"
#include "strategies/average_plane.h"
#include "strategies/cylinder_axis.h"
#include "strategies/fuzzy_per_vertex.h"
#include "strategies/joint_vertex.h"
#include "strategies/nearest_face.h"
#include "strategies/tool_facet.h"

namespace trocar {

const std::vector<StrategyEntry>& all_strategies() {
    // One strategy a line, so that adding one changes one line.
    // clang-format off
    static const std::vector<StrategyEntry> entries = {
        fuzzy_per_vertex_entry(),
        nearest_face_entry(),
        cylinder_axis_entry(),
        average_plane_entry(),
        joint_vertex_entry(),
        tool_facet_entry(),
    };
    // clang-format on
    return entries;
}

const StrategyEntry& find_strategy(std::string_view name) {
    const auto& entries = all_strategies();
    const auto found = std::ranges::find_if(
        entries, [&](const StrategyEntry& entry) { return entry.description.name == name; });
    if (found != entries.end()) return *found;
    std::vector<std::string> names;
    for (const StrategyEntry& entry : entries) names.push_back(entry.description.name);
    throw std::invalid_argument(unknown_name("strategy", name, names));
}

std::unique_ptr<Strategy> make_strategy(std::string_view name, const Options& given) {
    const StrategyEntry& entry = find_strategy(name);
    return entry.make(resolve_options(entry.description.options, given));
}

}  // namespace trocar
