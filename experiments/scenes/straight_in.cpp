#include "experiments/scenes/straight_in.h"

#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/window.h"

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

double way_out(const SceneInputs& inputs, const Placement& at, const Vec3& tip) {
    constexpr int most = 100;
    for (int k = 1; k < most; ++k) {
        const double way = k * clear;
        if (!window_of(inputs, {upright_pose(at, tip + way * at.normal)}).front()) return way;
    }
    return most * clear;
}

}  // namespace trocar::scenes
