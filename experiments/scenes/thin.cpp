#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {

SceneEntry thin() {
    return {.name = "thin",
            .summary = "as penetration, only where the opposite wall is nearer than 24 mm",
            .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = deep, .thin = true}); },
            .plan = [](const SceneInputs& inputs,
                       const Placement& at) { return straight_in(inputs, at, at.normal, deep); }};
}

}  // namespace trocar::scenes
