#include "experiments/cli/plot_rules.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/rules_file.h"
#include "experiments/cli/temporary_folder.h"
#include "experiments/input_error.h"
#include "strategies/fuzzy/inference.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Even, so that 0 and ±0.5 are among the samples; fine enough that a kink looks like one.
constexpr int samples = 800;

std::vector<double> sampled(double low, double high) {
    std::vector<double> x;
    for (int k = 0; k <= samples; ++k) x.push_back(low + (high - low) * k / samples);
    return x;
}

json inputs_json(const fuzzy::RuleBase& rules) {
    json inputs = json::array();
    for (std::size_t k = 0; k < rules.inputs.size(); ++k) {
        const bool signed_input = k == static_cast<std::size_t>(fuzzy::Input::collision_index);
        const std::vector<double> x = sampled(signed_input ? -1 : 0, 1);
        json terms = json::array();
        for (const auto& [name, membership] : rules.inputs.at(k)) {
            json y = json::array();
            for (const double value : x) y.push_back(fuzzy::degree(membership, value));
            terms.push_back({{"name", name}, {"y", y}});
        }
        inputs.push_back({{"name", fuzzy::input_names.at(k)}, {"x", x}, {"terms", terms}});
    }
    return inputs;
}

json outputs_json(const fuzzy::RuleBase& rules) {
    json outputs = json::array();
    for (std::size_t k = 0; k < rules.outputs.size(); ++k) {
        json terms = json::array();
        for (const auto& [name, weight] : rules.outputs.at(k).terms) {
            terms.push_back({{"name", name}, {"value", weight}});
        }
        outputs.push_back({{"name", fuzzy::output_names.at(k)}, {"terms", terms}});
    }
    return outputs;
}

json pass_json(const char* label, const std::vector<double>& x, const auto& weights_at) {
    json penetration = json::array(), sliding = json::array(), extraction = json::array();
    for (const double index : x) {
        const fuzzy::Weights weights = weights_at(index);
        penetration.push_back(weights.penetration);
        sliding.push_back(weights.sliding);
        extraction.push_back(weights.extraction);
    }
    return {{"label", label}, {"I_P", penetration}, {"I_S", sliding}, {"I_E", extraction}};
}

/// The weights over I_C at the first facet, and at a second one after a first of each pure case.
json response_json(const fuzzy::RuleBase& rules) {
    const fuzzy::Inference inference(rules);
    const std::vector<double> x = sampled(-1, 1);
    const auto after = [&](double first) {
        return [&inference, previous = inference.first(first)](double index) {
            return inference.further(index, previous);
        };
    };
    return {{"x", x},
            {"passes",
             {pass_json("first facet", x, [&](double index) { return inference.first(index); }),
              pass_json("after penetration", x, after(-1)), pass_json("after sliding", x, after(0)),
              pass_json("after extraction", x, after(1))}}};
}

}  // namespace

int plot_rules(const std::string& rules_name, const std::string& folder) {
    const fuzzy::RuleBase rules = read_rules_file(rules_name);
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder)) {
        throw InputError(fmt::format("{}: this folder cannot be made: {}", folder, error.message()));
    }
    const json picture = {{"output", folder},
                          {"title", rules.name},
                          {"inputs", inputs_json(rules)},
                          {"outputs", outputs_json(rules)},
                          {"response", response_json(rules)}};
    const TemporaryFolder temporary;
    const fs::path file = temporary.path() / "rules.json";
    std::ofstream(file) << picture;
    return run_analysis({"rules", "--", file.string()});
}

}  // namespace trocar
