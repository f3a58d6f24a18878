#pragma once

#include <string>
#include <vector>

#include "tests/strategies/contract_scene.h"

namespace trocar::contract {

/// The tools that every strategy is tried with, as make_tool_by_formula takes them.
const std::vector<std::string>& contract_tools();

/// The tool pushed some way into a dented sphere, or into a sheet, turning a little as it moves. The same for
/// the same seed and tool. Some vertex is collided.
Scene random_scene(std::uint64_t seed, const std::string& tool);
/// … any of the tools.
Scene random_scene(std::uint64_t seed);

/// A scene with a name for messages.
struct NamedScene {
    std::string name;
    Scene scene;
};

/// The tool moves, and nothing is collided after.
std::vector<NamedScene> scenes_without_contact();

/// What seldom happens by chance; some vertex is collided in each.
std::vector<NamedScene> degenerate_scenes(const std::string& tool);

}  // namespace trocar::contract
