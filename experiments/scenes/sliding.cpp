#include <vector>

#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"
#include "experiments/scenes/surface_way.h"

namespace trocar::scenes {
namespace {

// The design says straight along the tangent. A tool that goes so leaves a convex organ and slides in air: of
// the slide's steps at 20, 100 and 400 mm/s (prism-12, 20 seeds) 63, 58 and 44 % met sphere@4mm at rest, 55,
// 50 and 36 % gallbladder@2mm, 80, 76 and 69 % liver@4mm. Along the surface all of them meet it; on a flat
// sheet the way is the same.
constexpr double depth = 3;   // mm
constexpr double along = 30;  // mm of the surface

/// A tool that stands on the surface, so far (mm) above it along its axis.
Pose at_height(Pose pose, double height) {
    pose.position += height * pose.rotation.col(2);
    return pose;
}

ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    const Pose entry = upright_pose(at, at.entry), start = at_height(entry, -depth);
    std::vector<Pose> way = surface_way(inputs, entry, along).value();
    const Pose end = way.back();
    for (Pose& pose : way) pose = at_height(pose, -depth);
    Walk walk(start, inputs.speed, inputs.dt, at.phase);
    walk.go_along(way);
    walk.stay(hold_s);
    walk.go_to(at_height(end, clear).position);
    walk.stay(rest_s);
    return {.start = start, .poses = walk.poses(), .insertion = inserted(at, depth)};
}

}  // namespace

SceneEntry sliding() {
    return {
        .name = "sliding",
        .summary =
            "starts 3 mm deep in the organ at equilibrium, 30 mm along its surface, upright on it all "
            "the way, hold, straight out, rest",
        .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = depth, .along = along}); },
        .plan = plan};
}

}  // namespace trocar::scenes
