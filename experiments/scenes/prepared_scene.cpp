#include "experiments/scenes/prepared_scene.h"

#include <utility>

#include "experiments/metrics/judge/region.h"
#include "experiments/scenes/reference_state.h"
#include "experiments/scenes/window.h"

namespace trocar {

PreparedScene prepare_scene(const SceneEntry& scene, const SceneInputs& inputs, double clearance,
                            const SpringSettings& springs) {
    const Placement placement = scene.place(inputs);
    ScenePlan plan = scene.plan(inputs, placement);
    CycleStart start = plan.insertion
                           ? reference_state(inputs, plan.start, *plan.insertion, clearance, springs)
                           : start_at_rest(inputs.organ, plan.start);
    std::vector<bool> window = window_of(inputs, plan.poses);
    std::vector<Index> region = vertices_near_sweep(inputs.organ, inputs.tool, plan.start, plan.poses);
    return {.placement = placement,
            .start = std::move(start),
            .poses = std::move(plan.poses),
            .window = std::move(window),
            .region = std::move(region)};
}

}  // namespace trocar
