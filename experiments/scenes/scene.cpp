#include "experiments/scenes/scene.h"

#include <algorithm>

#include "common/nearest_name.h"
#include "experiments/scenes/scene_list.h"

namespace trocar {

const std::vector<SceneEntry>& all_scenes() {
    static const std::vector<SceneEntry> entries = {
        scenes::penetration(), scenes::thin(),  scenes::extraction(), scenes::sliding(),   scenes::oblique(),
        scenes::cutting(),     scenes::pivot(), scenes::twisting(),   scenes::breathing(), scenes::recorded(),
    };
    return entries;
}

const SceneEntry& find_scene(std::string_view name) {
    const auto& entries = all_scenes();
    const auto found = std::ranges::find(entries, name, &SceneEntry::name);
    if (found != entries.end()) return *found;
    std::vector<std::string> names;
    for (const SceneEntry& entry : entries) names.push_back(entry.name);
    throw std::invalid_argument(unknown_name("scene", name, names));
}

}  // namespace trocar
