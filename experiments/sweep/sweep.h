#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/cycle/cycle.h"
#include "common/deformation/spring_network.h"
#include "common/geometry/mesh_check.h"
#include "common/geometry/organ.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool.h"
#include "experiments/metrics/judge/judged_organ.h"
#include "experiments/metrics/judge/judged_tool.h"
#include "experiments/scenes/scene.h"
#include "strategies/options.h"

namespace trocar {

/// A strategy as a sweep names it.
struct StrategyChoice {
    std::string name;   ///< of the strategy
    std::string label;  ///< as it stands in tables and figures; unique within a sweep
    Options options;    ///< resolved: all of them, defaults included
};

/// An organ as a sweep names it, loaded.
struct OrganChoice {
    /// What makes it this organ: "sphere@4mm", or the hash of a file's bytes with the size it is scaled to.
    /// Where the file lies is not part of it.
    std::string identity;
    std::shared_ptr<const Organ> organ;
    std::shared_ptr<const SurfaceQueries> queries;  ///< of `organ` at rest
    std::shared_ptr<const JudgedOrgan> judged;      ///< `organ` as the metrics see it
    std::vector<Finding> findings;  ///< what was mended in a mesh file, and what is worth knowing
};

/// A tool as a sweep names it, loaded.
struct ToolChoice {
    /// What makes it this tool: its name, which states shape and parameters, or the hash of a file's bytes
    /// with how it is turned, placed and scaled.
    std::string identity;
    std::shared_ptr<const Tool> tool;
    std::shared_ptr<const JudgedTool> judged;  ///< `tool` as the metrics see it
    std::vector<Finding> findings;             ///< as of an organ
};

/// A scene as a sweep names it, with its recording loaded.
struct SceneChoice {
    const SceneEntry* entry;
    std::string
        name;  ///< as it is written in results: the scene's, and a recording's file name without its end
    std::string identity;  ///< what makes it this scene: its name, and the hash of a recording
    std::shared_ptr<const Recording> recording;  ///< of a scene that needs one
};

/// A sweep file, read and checked: everything it names exists, is loaded once and shared. The cases are the
/// full product of the lists.
struct Sweep {
    std::string name;
    std::string text;  ///< of the file
    std::vector<StrategyChoice> strategies;
    std::vector<OrganChoice> organs;
    std::vector<ToolChoice> tools;
    std::vector<SceneChoice> scenes;
    std::vector<double> speeds;        ///< mm/s; a recording has its own
    std::vector<std::uint64_t> seeds;  ///< `seeds = 3` stands for 1, 2, 3
    CycleSettings cycle;               ///< but for the rate and the release
    std::vector<double> rates;         ///< Hz
    std::vector<Release> releases;
    SpringSettings springs;
    std::vector<double> stiffnesses;  ///< factors of both of the springs' stiffnesses
    int same_state = 0;               ///< states of each run that are handed to every strategy
};

/// Reads a sweep file (TOML; README.md of this folder lists the keys) and loads the organs and tools it
/// names. Throws InputError that starts with "file:line:column: " for anything wrong in it, and one that
/// names the mesh file for a mesh that cannot be used.
Sweep read_sweep(const std::filesystem::path& file);

}  // namespace trocar
