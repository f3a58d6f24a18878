#include "experiments/sweep/cases.h"

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

std::string release_name(Release release) { return release == Release::contact ? "contact" : "step"; }

std::string case_id_of(const CaseInputs& inputs) {
    const nlohmann::json object{
        {"strategy", inputs.strategy.name},
        {"options", to_json(inputs.strategy.options)},
        {"organ", inputs.organ.identity},
        {"tool", inputs.tool.identity},
        {"scene", inputs.scene},
        {"speed", inputs.speed},
        {"seed", inputs.seed},
        {"fractions", 1},
        {"cycle",
         {{"rate", inputs.cycle.rate},
          {"clearance", inputs.cycle.clearance},
          {"release", release_name(inputs.cycle.release)}}},
        {"deformation",
         {{"density", inputs.springs.density},
          {"edge_stiffness", inputs.springs.edge_stiffness},
          {"rest_stiffness", inputs.springs.rest_stiffness},
          {"damping", inputs.springs.damping},
          {"substeps", inputs.springs.substeps}}},
    };
    return hash_of(object.dump());
}

std::vector<CaseInputs> list_cases(const Sweep& sweep) {
    std::vector<CaseInputs> cases;
    const auto add = [&](const StrategyChoice& strategy, const OrganChoice& organ, const ToolChoice& tool,
                         const std::string& scene, double speed, std::uint64_t seed) {
        CaseInputs& inputs = cases.emplace_back(CaseInputs{.case_id = {},
                                                           .strategy = strategy,
                                                           .organ = organ,
                                                           .tool = tool,
                                                           .scene = scene,
                                                           .speed = speed,
                                                           .seed = seed,
                                                           .cycle = sweep.cycle,
                                                           .springs = sweep.springs});
        inputs.case_id = case_id_of(inputs);
    };
    for (const auto& strategy : sweep.strategies) {
        for (const auto& organ : sweep.organs) {
            for (const auto& tool : sweep.tools) {
                for (const auto& scene : sweep.scenes) {
                    for (const double speed : sweep.speeds) {
                        for (const auto seed : sweep.seeds) add(strategy, organ, tool, scene, speed, seed);
                    }
                }
            }
        }
    }
    return cases;
}

}  // namespace trocar
