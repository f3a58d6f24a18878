#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/metric_pictures.h"
#include "experiments/cli/scene_picture.h"
#include "experiments/input_error.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "A step of a run that has stored replays (trocar run --replay); or, with --scene, a scene before "
    "anything\n"
    "runs: where the tool starts, where it goes, what it starts in; or, with --metric, a made-up step that "
    "the\n"
    "metric catches, with its value.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the "
    "analysis.\n"
    "Example:\n"
    "  trocar snapshot results.h5 --case 3f2a --step deepest -o step.png\n"
    "  trocar snapshot --scene penetration --organ liver@4mm --seed 3 -o scene.png\n"
    "  trocar snapshot --metric depth_max -o depth_max.png";

/// What of a result file to draw.
struct StepRequest {
    std::string file, case_id, step, moment;
    bool alone = false;

    [[nodiscard]] std::vector<std::string> arguments(const std::string& output) const {
        std::vector<std::string> words{"snapshot", "--output=" + output};
        if (!case_id.empty()) words.push_back("--case=" + case_id);
        if (!step.empty()) words.push_back("--step=" + step);
        if (!moment.empty()) words.push_back("--moment=" + moment);
        if (alone) words.emplace_back("--alone");
        words.insert(words.end(), {"--", file});
        return words;
    }
};

struct SnapshotOptions {
    StepRequest step;
    SceneRequest scene;
    std::string metric, output;
};

int snapshot(const SnapshotOptions& options) {
    const bool of_step = !options.step.file.empty(), of_scene = !options.scene.scene.empty(),
               of_metric = !options.metric.empty();
    if (int{of_step} + int{of_scene} + int{of_metric} != 1) {
        throw InputError(
            "snapshot needs one of a result file, --scene and --metric (see trocar snapshot --help)");
    }
    if (of_step) return run_analysis(options.step.arguments(options.output));
    if (of_metric) return draw_metric(options.metric, options.output);
    if (options.scene.organ.empty()) throw InputError("--scene needs --organ, such as --organ liver@4mm");
    return draw_scene(options.scene, options.output);
}

void add_step_options(CLI::App& command, StepRequest& step) {
    command.add_option("RESULTS", step.file, "result file of a run with --replay");
    command.add_option("--case", step.case_id,
                       "case id, or its beginning where only one begins so; without it, where the file has\n"
                       "replays of several conditions, the cases are listed");
    command.add_option("--step", step.step, "number from 0, -1 for the last; without it the deepest step");
    command.add_option("--moment", step.moment, "found, handled or deformed; without it handled");
    command.add_flag("--alone", step.alone, "this case only, without the other strategies beside it");
}

void add_scene_options(CLI::App& command, SceneRequest& scene) {
    command.add_option("--scene", scene.scene, "draw this scene; see trocar list scenes");
    command.add_option("--organ", scene.organ, "of the scene: a formula, or a mesh file");
    command.add_option("--size", scene.organ_size, "of an organ from a mesh file: its longest side, mm")
        ->check(CLI::PositiveNumber);
    command.add_option("--tool", scene.tool, "of the scene")->capture_default_str();
    command.add_option("--speed", scene.speed, "of the scene, mm/s")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_option("--seed", scene.seed, "of the scene")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_option("--recording", scene.recording, "CSV of poses, of the scene recorded");
    command.add_option("--frame", scene.frame, "of the recording: organ or entry")
        ->check(CLI::IsMember({"organ", "entry"}))
        ->capture_default_str();
}

}  // namespace

void add_snapshot(CLI::App& app, Program& program) {
    auto options = std::make_shared<SnapshotOptions>();
    CLI::App* command = app.add_subcommand(
        "snapshot", "Draw one step of a case, a scene, or what a metric counts, as a picture");
    command->footer(footer);
    add_step_options(*command, options->step);
    add_scene_options(*command, options->scene);
    command->add_option(
        "--metric", options->metric,
        "draw the example of this metric; see trocar list metrics. With \"all\" of each, into\n"
        "the folder -o");
    command->add_option("-o,--output", options->output, "picture to write: .png or .svg")->required();
    command->callback([options, &program] { program.exit_code = snapshot(*options); });
}

}  // namespace trocar
