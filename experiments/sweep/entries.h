#pragma once

#include <filesystem>

#include "experiments/sweep/config.h"
#include "experiments/sweep/sweep.h"

namespace trocar {

// What the lists of a sweep hold, and its two tables of settings. All throw PlacedError.

/// A strategy's name, or a table of `name`, perhaps `label`, and the strategy's own options.
StrategyChoice read_strategy_entry(const ConfigValue& entry);

/// A formula such as "sphere@4mm", or a table of `file` (relative to `folder`) and perhaps `size` in mm.
/// Throws MeshError for a file that cannot be used.
OrganChoice read_organ_entry(const ConfigValue& entry, const std::filesystem::path& folder);

/// A tool's name, or a table of `shape` and that shape's parameters.
ToolChoice read_tool_entry(const ConfigValue& entry);

/// A scene's name, or a table of `name`, `file` (relative to `folder`) and perhaps `frame` for a recorded
/// motion. Throws InputError, which names the file, for a recording that cannot be used.
SceneChoice read_scene_entry(const ConfigValue& entry, const std::filesystem::path& folder);

/// All of [cycle] but the release.
CycleSettings read_cycle(const ConfigTable& table);
/// One word, or a list of them; without the key the default one.
std::vector<Release> read_releases(const ConfigTable& cycle);
/// All of [deformation].
SpringSettings read_springs(const ConfigTable& table);

}  // namespace trocar
