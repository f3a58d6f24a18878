#include <algorithm>

#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {
namespace {

constexpr double depth = 3;  // mm
constexpr double way = 30;   // mm, along the tangent

ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    const Vec3 start_tip = at.entry - depth * at.normal, end_tip = start_tip + way * at.tangent;
    const Pose start = upright_pose(at, start_tip);
    Walk walk(start, inputs.speed, inputs.dt, at.phase);
    walk.go_to(end_tip);
    walk.stay(hold_s);
    walk.go_to(end_tip + std::max(depth + clear, way_out(inputs, at, end_tip)) * at.normal);
    walk.stay(rest_s);
    return {.start = start, .poses = walk.poses(), .insertion = inserted(at, depth)};
}

}  // namespace

SceneEntry sliding() {
    return {
        .name = "sliding",
        .summary = "starts 3 mm deep in the organ at equilibrium, 30 mm sideways, hold, straight out, rest",
        .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = depth, .aside = way}); },
        .plan = plan};
}

}  // namespace trocar::scenes
