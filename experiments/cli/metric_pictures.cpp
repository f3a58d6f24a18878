#include "experiments/cli/metric_pictures.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/picture_json.h"
#include "experiments/cli/temporary_folder.h"
#include "experiments/input_error.h"
#include "experiments/metrics/examples/example.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json description_of(const Panel& panel) {
    json segments = json::array();
    for (const auto& segment : panel.marks.segments) segments.push_back(picture_json(segment));
    return {{"title", panel.title},
            {"positions", picture_json(panel.positions)},
            {"tool", picture_json(panel.tool)},
            {"arrows_from", picture_json(panel.from)},
            {"marked_vertices", panel.marks.vertices},
            {"marked_facets", panel.marks.facets},
            {"marked_segments", segments},
            {"marked_points", picture_json(panel.marks.points)}};
}

json description_of(const Example& example, const std::string& output) {
    json panels = json::array();
    for (const Panel& panel : example.panels) panels.push_back(description_of(panel));
    return {{"output", output},
            {"metric", example.metric},
            {"value", judge_example(example).value},
            {"units", choose_metrics(example.metric).front()->units},
            {"caption", example.caption},
            {"towards_eye", picture_json(example.eye.towards)},
            {"centre", picture_json(example.eye.centre)},
            {"width", example.eye.width},
            {"height", example.eye.height},
            {"cut", example.eye.cut},
            {"organ_facets", example.organ.rest.facets},
            {"tool_positions", picture_json(example.tool.mesh.positions)},
            {"tool_facets", example.tool.mesh.facets},
            {"panels", panels}};
}

json describe(const std::string& metric, const std::string& output) {
    json pictures = json::array();
    if (metric != "all") {
        pictures.push_back(description_of(find_example(metric), output));
        return pictures;
    }
    if (!fs::is_directory(output)) {
        throw InputError(
            fmt::format("{}: is no folder; --metric all needs one to write NAME.png into", output));
    }
    for (const Example& example : all_examples()) {
        pictures.push_back(description_of(example, (fs::path(output) / (example.metric + ".png")).string()));
    }
    return pictures;
}

}  // namespace

int draw_metric(const std::string& metric, const std::string& output) {
    const json pictures = describe(metric, output);
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "metrics.json";
    std::ofstream(file) << pictures;
    return run_analysis({"metrics", "--", file.string()});
}

}  // namespace trocar
