#include "experiments/cli/explain_numbers.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "experiments/cli/rules_file.h"
#include "experiments/cli/vertex_story.h"
#include "experiments/input_error.h"
#include "strategies/fuzzy/rules_option.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

/// The numbers between the commas; empty where one of them is no finite number.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        double number = 0;
        const char* const end = part.data() + part.size();
        const auto [stopped, error] = std::from_chars(part.data(), end, number);
        if (error != std::errc() || stopped != end || !std::isfinite(number)) return {};
        numbers.push_back(number);
    }
    return numbers;
}

/// The unit vector along what "x,y,z" says.
Vec3 unit_vector(const std::string& text, const char* option) {
    const std::vector<double> numbers = numbers_of(text);
    const Vec3 vector = numbers.size() == 3 ? Vec3(numbers[0], numbers[1], numbers[2]) : Vec3(Vec3::Zero());
    if (vector.isZero(0)) {
        throw InputError(fmt::format("{} {}: expected a direction x,y,z, such as 0,0,-1", option, text));
    }
    return vector.stableNormalized();
}

Options options_of(const std::vector<std::string>& texts) {
    Options options;
    for (const std::string& text : texts) {
        const auto equals = text.find('=');
        if (equals == std::string::npos) {
            throw InputError(fmt::format("--option {}: expected key=value, such as feedback=false", text));
        }
        const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
        if (key == "rules") {
            options[key] = rules_text(value);
        } else if (value == "true" || value == "false") {
            options[key] = value == "true";
        } else {
            options[key] = value;
        }
    }
    try {
        return resolve_options(find_strategy("fuzzy-per-vertex").description.options, options);
    } catch (const OptionError& error) {
        throw InputError(fmt::format("--option: {}", error.what()));
    }
}

}  // namespace

std::string explain_numbers(const ExplainNumbers& asked) {
    const Options options = options_of(asked.options);
    const fuzzy::RuleBase rules = fuzzy::rules_of(options);
    const fuzzy::VertexReading reading = fuzzy::vertex_reading_of(options);
    const Vec3 motion = unit_vector(asked.motion, "--motion");
    std::vector<fuzzy::FacetNormal> facets;
    for (const std::string& normal : asked.normals) {
        facets.push_back({static_cast<Index>(facets.size() + 1), unit_vector(normal, "--normal")});
    }
    fuzzy::put_in_order(facets, motion, reading);
    return told(story_of(rules, reading, motion, facets), rules, reading);
}

}  // namespace trocar
