#include "experiments/sweep/cases.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

nlohmann::json to_json(const Options& options) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [name, value] : options) {
        nlohmann::json& member = object[name];
        std::visit([&](const auto& plain) { member = plain; }, value);
    }
    return object;
}

}  // namespace

std::string options_json(const Options& options) { return to_json(options).dump(); }

namespace {

/// Of the contents of a file, which may be long, the first line that is no comment.
std::string telling_line(std::string_view text) {
    while (text.find('\n') != std::string_view::npos) {
        const std::string_view line = text.substr(0, text.find('\n'));
        if (!line.empty() && line.front() != '#') return std::string(line);
        text.remove_prefix(line.size() + 1);
    }
    return std::string(text);
}

}  // namespace

std::string option_text(const OptionValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return telling_line(*text);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    return fmt::format("{}", std::get<double>(value));
}

std::string release_name(Release release) { return release == Release::contact ? "contact" : "step"; }

namespace {

/// What decides how a scene starts and goes on, whatever the strategy.
nlohmann::json scene_json(const CaseInputs& inputs) {
    return {
        {"organ", inputs.organ.identity},
        {"tool", inputs.tool.identity},
        {"scene", inputs.scene.identity},
        {"speed", inputs.speed},
        {"seed", inputs.seed},
        {"fractions", 1},
        {"cycle", {{"rate", inputs.cycle.rate}, {"clearance", inputs.cycle.clearance}}},
        {"deformation",
         {{"density", inputs.springs.density},
          {"edge_stiffness", inputs.springs.edge_stiffness},
          {"rest_stiffness", inputs.springs.rest_stiffness},
          {"damping", inputs.springs.damping},
          {"substeps", inputs.springs.substeps}}},
    };
}

}  // namespace

std::string case_id_of(const CaseInputs& inputs) {
    nlohmann::json object = scene_json(inputs);
    object["strategy"] = inputs.strategy.name;
    object["options"] = to_json(inputs.strategy.options);
    object["cycle"]["release"] = release_name(inputs.cycle.release);
    // Of the scene's start nothing sleeps. The full simulation has the ids that it had before there was
    // sleep.
    if (inputs.springs.sleep) object["deformation"]["sleep"] = true;
    return hash_of(object.dump());
}

namespace {

/// What the cases of a sweep have in common besides strategy, organ, tool, scene, speed and seed.
struct Settings {
    CycleSettings cycle;
    SpringSettings springs;
};

/// The product of the releases, rates and stiffnesses, the last one changing fastest.
std::vector<Settings> settings_of(const Sweep& sweep) {
    std::vector<Settings> all;
    for (const Release release : sweep.releases) {
        for (const double rate : sweep.rates) {
            for (const double stiffness : sweep.stiffnesses) {
                Settings& one = all.emplace_back(Settings{.cycle = sweep.cycle, .springs = sweep.springs});
                one.cycle.release = release;
                one.cycle.rate = rate;
                one.springs.edge_stiffness *= stiffness;
                one.springs.rest_stiffness *= stiffness;
            }
        }
    }
    return all;
}

}  // namespace

std::vector<CaseInputs> list_cases(const Sweep& sweep) {
    std::vector<CaseInputs> cases;
    const auto add = [&](const StrategyChoice& strategy, const Settings& settings, const OrganChoice& organ,
                         const ToolChoice& tool, const SceneChoice& scene, double speed, std::uint64_t seed) {
        CaseInputs& inputs = cases.emplace_back(CaseInputs{.case_id = {},
                                                           .scene_id = {},
                                                           .strategy = strategy,
                                                           .organ = organ,
                                                           .tool = tool,
                                                           .scene = scene,
                                                           .speed = speed,
                                                           .seed = seed,
                                                           .cycle = settings.cycle,
                                                           .springs = settings.springs,
                                                           .sweep_number = {}});
        inputs.sweep_number = static_cast<std::int64_t>(cases.size());
        inputs.case_id = case_id_of(inputs);
        inputs.scene_id = hash_of(scene_json(inputs).dump());
    };
    const auto add_scenes = [&](const StrategyChoice& strategy, const Settings& settings,
                                const OrganChoice& organ, const ToolChoice& tool) {
        for (const SceneChoice& scene : sweep.scenes) {
            const std::vector<double> speeds =
                scene.recording ? std::vector{scene.recording->motion.tip_speed()} : sweep.speeds;
            for (const double speed : speeds) {
                for (const auto seed : sweep.seeds) add(strategy, settings, organ, tool, scene, speed, seed);
            }
        }
    };
    const std::vector<Settings> all_settings = settings_of(sweep);
    for (const auto& strategy : sweep.strategies) {
        for (const Settings& settings : all_settings) {
            for (const auto& organ : sweep.organs) {
                for (const auto& tool : sweep.tools) add_scenes(strategy, settings, organ, tool);
            }
        }
    }
    return cases;
}

}  // namespace trocar
