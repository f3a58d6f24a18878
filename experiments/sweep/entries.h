#pragma once

#include <filesystem>

#include "experiments/sweep/config.h"
#include "experiments/sweep/sweep.h"

namespace trocar {

// What the lists of a sweep hold, and its two tables of settings. All throw PlacedError.

/// A strategy's name, or a table of `name`, perhaps `label`, and the strategy's own options. An option's
/// value may be a list of values: then there is one choice for each, or for each of the product of several
/// lists, the last of which changes fastest. Where an option takes what a file holds, its value may be a
/// path, relative to `folder`. Throws InputError, which names file and line, for contents that cannot be
/// used.
std::vector<StrategyChoice> read_strategy_entry(const ConfigValue& entry,
                                                const std::filesystem::path& folder);

/// A formula such as "sphere@4mm", or a table of `file` (relative to `folder`) and perhaps `size` in mm.
/// Throws MeshError for a file that cannot be used.
OrganChoice read_organ_entry(const ConfigValue& entry, const std::filesystem::path& folder);

/// A tool's name, a table of `shape` and that shape's parameters, or a table with `file`.
ToolChoice read_tool_entry(const ConfigValue& entry, const std::filesystem::path& folder);

/// A table of `file` (relative to `folder`), `axis` and perhaps `tip`, `size` and `name`. Throws MeshError
/// for a file that cannot be used. @param place of the table
ToolChoice read_tool_file(const ConfigTable& table, const ConfigValue& file, Place place,
                          const std::filesystem::path& folder);

/// A tool, prepared for a sweep.
ToolChoice tool_choice(std::string identity, Tool&& tool, std::vector<Finding> findings);

/// The path that the text under a key `file` names; the file exists.
std::filesystem::path mesh_file(const ConfigValue& file, const std::filesystem::path& folder);

/// A scene's name, or a table of `name`, `file` (relative to `folder`) and perhaps `frame` for a recorded
/// motion. Throws InputError, which names the file, for a recording that cannot be used.
SceneChoice read_scene_entry(const ConfigValue& entry, const std::filesystem::path& folder);

/// All of [cycle] but the rate and the release, with defaults where the table has none.
CycleSettings read_cycle(const ConfigTable& table);
/// The rate of [cycle]: one number, or a list of them; without the key the default one.
std::vector<double> read_rates(const ConfigTable& cycle);
/// The release of [cycle]: one word, or a list of them; without the key the default one.
std::vector<Release> read_releases(const ConfigTable& cycle);
/// How many states of each run `same_state` of [compare] asks for; 0 where the table has none.
int read_same_state(const ConfigTable& compare);
/// The settings of [deformation] but for the factor, with defaults where the table has none.
SpringSettings read_springs(const ConfigTable& table);
/// The key `stiffness` of [deformation]: one factor, or a list of them; without the key 1.
std::vector<double> read_stiffnesses(const ConfigTable& deformation);

}  // namespace trocar
