#include "experiments/scenes/penetration.h"

#include "experiments/scenes/placement.h"
#include "experiments/scenes/walk.h"
#include "experiments/scenes/window.h"

namespace trocar {
namespace {

constexpr double clear = 3;     // mm outside the organ, before and after
constexpr double depth = 12;    // mm below the organ's surface at rest
constexpr double hold_s = 0.5;  // at the deepest point
constexpr double rest_s = 1;    // after the tool has left

ScenePlan plan(const SceneInputs& inputs) {
    const Placement placement = place(inputs, depth);
    const Vec3 outside = placement.entry + clear * placement.normal;
    const Vec3 deepest = placement.entry - depth * placement.normal;
    const Pose start = upright_pose(placement, outside);

    Walk walk(start, inputs.speed, inputs.dt, placement.phase);
    walk.go_to(deepest);
    walk.stay(hold_s);
    walk.go_to(outside);
    walk.stay(rest_s);
    return {.placement = placement,
            .start = start,
            .poses = walk.poses(),
            .window = window_of(inputs, walk.poses())};
}

}  // namespace

SceneEntry penetration_entry() {
    return {.name = "penetration",
            .summary = "straight in along the surface normal to 12 mm, hold, straight out, rest",
            .plan = plan};
}

}  // namespace trocar
