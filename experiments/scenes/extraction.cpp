#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {
namespace {

constexpr double depth = 8;  // mm, at the start

ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    const Pose start = upright_pose(at, at.entry - depth * at.normal);
    Walk walk(start, inputs.speed, inputs.dt, at.phase);
    walk.go_to(at.entry + clear * at.normal);
    walk.stay(rest_s);
    return {.start = start, .poses = walk.poses(), .insertion = inserted(at, depth)};
}

}  // namespace

SceneEntry extraction() {
    return {.name = "extraction",
            .summary = "starts 8 mm deep in the organ at equilibrium, straight out, rest",
            .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = depth}); },
            .plan = plan};
}

}  // namespace trocar::scenes
