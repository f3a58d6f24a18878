#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {

SceneEntry penetration() {
    return {.name = "penetration",
            .summary = "straight in along the surface normal to 12 mm, hold, straight out, rest",
            .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = deep}); },
            .plan = [](const SceneInputs& inputs,
                       const Placement& at) { return straight_in(inputs, at, at.normal, deep); }};
}

}  // namespace trocar::scenes
