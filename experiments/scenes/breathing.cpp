#include <cmath>
#include <numbers>

#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"

namespace trocar::scenes {
namespace {

constexpr double rise = clear + deep;  // mm, of the organ along n

/// One breath: the organ rises along n by (1 − cos)/2 onto a tool that is held still, and sinks again. Its
/// greatest speed is the scene's.
ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    const Pose tool = upright_pose(at, at.entry + clear * at.normal);
    const double period = std::numbers::pi * rise / inputs.speed;  // s
    const auto organ_at = [&](double time) {
        Pose organ;
        organ.position = rise * (1 - std::cos(2 * std::numbers::pi * time / period)) / 2 * at.normal;
        return organ;
    };
    ScenePlan plan{.start = tool, .poses = {}, .insertion = {}};
    const auto moving = static_cast<std::size_t>(std::ceil(period / inputs.dt - at.phase));
    for (std::size_t k = 0; k < moving; ++k) {
        plan.poses.push_back(tool.seen_from(organ_at((at.phase + static_cast<double>(k)) * inputs.dt)));
    }
    const auto resting = static_cast<std::size_t>(std::lround(rest_s / inputs.dt));
    plan.poses.insert(plan.poses.end(), 1 + resting, tool);  // the breath ends exactly where it began
    return plan;
}

}  // namespace

SceneEntry breathing() {
    return {.name = "breathing",
            .summary = "the tool is held still and the organ moves: one breath onto the tool and back, rest",
            .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = deep}); },
            .plan = plan};
}

}  // namespace trocar::scenes
