#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {

SceneEntry oblique() {
    // Along (t − n)/√2 a tip that is 12 mm deep has also gone 12 mm sideways.
    return {
        .name = "oblique",
        .summary = "the tool upright, in at 45 degrees to 12 mm, hold, back the same way, rest",
        .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = deep, .aside = deep}); },
        .plan = [](const SceneInputs& inputs,
                   const Placement& at) { return straight_in(inputs, at, at.normal - at.tangent, deep); }};
}

}  // namespace trocar::scenes
