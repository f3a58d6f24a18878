#include "experiments/cli/scene_picture.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include "common/geometry/mesh_error.h"
#include "common/geometry/mesh_input.h"
#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/cli/analysis_program.h"
#include "experiments/input_error.h"
#include "experiments/scenes/prepared_scene.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A folder of its own, removed with all that is in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "trocar-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw InputError(fmt::format("cannot make a folder in {}", fs::temp_directory_path().string()));
        }
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

Organ organ_of(const SceneRequest& request) {
    if (fs::is_regular_file(request.organ)) return read_organ(request.organ, request.organ_size).organ;
    if (request.organ_size) throw InputError("--size is for an organ from a mesh file");
    return make_organ_by_formula(request.organ);
}

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

json to_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

json to_json(std::span<const Vec3> points) {
    json list = json::array();
    for (const Vec3& point : points) list.push_back(to_json(point));
    return list;
}

/// Rows of the 4 by 4 matrix that takes the tool's coordinates to the world's.
json to_json(const Pose& pose) {
    json rows = json::array();
    for (int row = 0; row < 3; ++row) {
        rows.push_back(
            {pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2), pose.position[row]});
    }
    rows.push_back({0, 0, 0, 1});
    return rows;
}

json description_of(const SceneRequest& request, const Organ& organ, const Tool& tool,
                    const PreparedScene& scene) {
    json poses = json::array();
    for (const Pose& pose : scene.poses) poses.push_back(to_json(pose));
    return {{"scene", request.scene},
            {"organ", organ.name},
            {"tool", tool.name},
            {"speed", request.speed},
            {"seed", request.seed},
            {"organ_positions", to_json(scene.start.organ.positions)},
            {"organ_facets", organ.rest.facets},
            {"tool_positions", to_json(tool.mesh.positions)},
            {"tool_facets", tool.mesh.facets},
            {"start", to_json(scene.start.tool)},
            {"poses", poses},
            {"window", scene.window},
            {"entry", to_json(scene.placement.entry)},
            {"normal", to_json(scene.placement.normal)},
            {"tangent", to_json(scene.placement.tangent)}};
}

}  // namespace

int draw_scene(const SceneRequest& request, const std::string& output) {
    try {
        const SceneEntry& scene = find_scene(request.scene);
        const Organ organ = organ_of(request);
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
