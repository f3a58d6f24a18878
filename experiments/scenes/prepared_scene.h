#pragma once

#include <vector>

#include "common/cycle/cycle.h"
#include "experiments/scenes/scene.h"

namespace trocar {

/// A scene that can be run: the same for every strategy.
struct PreparedScene {
    Placement placement;
    CycleStart start;
    std::vector<Pose> poses;   ///< of the tool at the end of each step
    std::vector<bool> window;  ///< per step: the tool at its pose meets the organ at rest, so the step counts
    std::vector<Index> region;  ///< vertices that at rest are near the tool's sweep, ascending
};

/// Places a scene, lays it out, and brings the organ to the state it starts from. Throws PlacementError, and
/// what reference_state throws.
/// @param clearance g, mm
PreparedScene prepare_scene(const SceneEntry& scene, const SceneInputs& inputs,
                            double clearance = CycleSettings{}.clearance, const SpringSettings& springs = {});

}  // namespace trocar
