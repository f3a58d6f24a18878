#include "experiments/run/shared_scenes.h"

namespace trocar {

PreparedScene prepare_scene_of(const CaseInputs& inputs) {
    return prepare_scene(*inputs.scene.entry,
                         {.organ = *inputs.organ.organ,
                          .organ_queries = *inputs.organ.queries,
                          .tool = *inputs.tool.tool,
                          .speed = inputs.speed,
                          .dt = inputs.cycle.dt(),
                          .seed = inputs.seed,
                          .recording = inputs.scene.recording.get()},
                         inputs.cycle.clearance, inputs.springs);
}

SharedScenes::SharedScenes(std::span<const CaseInputs> cases) {
    for (const CaseInputs& inputs : cases) ++scenes_[inputs.scene_id].cases_to_come;
}

std::shared_ptr<const PreparedScene> SharedScenes::scene_of(const CaseInputs& inputs) {
    std::promise<std::shared_ptr<const PreparedScene>> promise;
    std::shared_future<std::shared_ptr<const PreparedScene>> scene;
    bool first = false;
    {
        const std::scoped_lock lock(guard_);
        Shared& shared = scenes_[inputs.scene_id];
        first = !shared.scene.valid();
        if (first) shared.scene = promise.get_future();
        scene = shared.scene;
        if (--shared.cases_to_come == 0) scenes_.erase(inputs.scene_id);
    }
    if (first) {
        try {
            promise.set_value(std::make_shared<const PreparedScene>(prepare_scene_of(inputs)));
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
    }
    return scene.get();
}

}  // namespace trocar
