#include "experiments/cli/scene_picture.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/tool/tool_shapes.h"
#include "experiments/cli/analysis_program.h"
#include "experiments/cli/organ_argument.h"
#include "experiments/cli/picture_json.h"
#include "experiments/cli/temporary_folder.h"
#include "experiments/input_error.h"
#include "experiments/scenes/prepared_scene.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::optional<Recording> recording_of(const SceneRequest& request, const SceneEntry& scene) {
    if (!scene.needs_recording) {
        if (request.recording.empty()) return {};
        throw InputError(fmt::format("--recording: the scene {} does not use one", scene.name));
    }
    if (request.recording.empty()) {
        throw InputError(fmt::format("the scene {} needs --recording FILE.csv", scene.name));
    }
    try {
        return Recording{
            .motion = parse_recorded_motion(read_bytes(request.recording)),
            .frame = request.frame == "entry" ? Recording::Frame::entry : Recording::Frame::organ};
    } catch (const MotionError& error) {
        throw InputError(fmt::format("{}:{}", request.recording, error.what()));
    }
}

json description_of(const SceneRequest& request, const Organ& organ, const Tool& tool,
                    const PreparedScene& scene) {
    json poses = json::array();
    for (const Pose& pose : scene.poses) poses.push_back(picture_json(pose));
    return {{"scene", request.scene},
            {"organ", organ.name},
            {"tool", tool.name},
            {"speed", request.speed},
            {"seed", request.seed},
            {"organ_positions", picture_json(scene.start.organ.positions)},
            {"organ_facets", organ.rest.facets},
            {"tool_positions", picture_json(tool.mesh.positions)},
            {"tool_facets", tool.mesh.facets},
            {"start", picture_json(scene.start.tool)},
            {"poses", poses},
            {"window", scene.window},
            {"entry", picture_json(scene.placement.entry)},
            {"normal", picture_json(scene.placement.normal)},
            {"tangent", picture_json(scene.placement.tangent)}};
}

}  // namespace

int draw_scene(const SceneRequest& request, const std::string& output) {
    try {
        const SceneEntry& scene = find_scene(request.scene);
        const Organ organ = organ_of_argument(request.organ, request.organ_size).organ;
        const Tool tool = make_tool_by_formula(request.tool);
        const SurfaceQueries queries(organ.rest);
        const std::optional<Recording> recording = recording_of(request, scene);
        const PreparedScene prepared =
            prepare_scene(scene, {.organ = organ,
                                  .organ_queries = queries,
                                  .tool = tool,
                                  .speed = recording ? recording->motion.tip_speed() : request.speed,
                                  .dt = CycleSettings{}.dt(),
                                  .seed = request.seed,
                                  .recording = recording ? &*recording : nullptr});
        const TemporaryFolder folder;
        const fs::path file = folder.path() / "scene.json";
        std::ofstream(file) << description_of(request, organ, tool, prepared);
        return run_analysis({"scene", "--output=" + output, "--", file.string()});
    } catch (const PlacementError& error) {
        throw InputError(error.what());
    }
}

}  // namespace trocar
