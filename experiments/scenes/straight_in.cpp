#include "experiments/scenes/straight_in.h"

#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"

namespace trocar::scenes {

ScenePlan straight_in(const SceneInputs& inputs, const Placement& at, const Vec3& out, double depth) {
    const Vec3 outside = at.entry + clear * out;
    const Pose start = upright_pose(at, outside);
    Walk walk(start, inputs.speed, inputs.dt, at.phase);
    walk.go_to(at.entry - depth * out);
    walk.stay(hold_s);
    walk.go_to(outside);
    walk.stay(rest_s);
    return {.start = start, .poses = walk.poses(), .insertion = {}};
}

Insertion inserted(const Placement& at, double depth) {
    return {.direction = -at.normal, .length = depth + clear};
}

}  // namespace trocar::scenes
