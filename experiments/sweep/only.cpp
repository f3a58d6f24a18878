#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "experiments/input_error.h"
#include "experiments/sweep/cases.h"

namespace trocar {
namespace {

/// Those that every case has, then the options of the cases' strategies.
std::vector<std::string> filter_keys(const std::vector<CaseInputs>& cases) {
    std::vector<std::string> keys{"strategy", "label", "organ",   "tool",           "scene",         "speed",
                                  "seed",     "rate",  "release", "edge_stiffness", "rest_stiffness"};
    std::set<std::string> options;
    for (const CaseInputs& inputs : cases) {
        for (const auto& option : inputs.strategy.options) options.insert(option.first);
    }
    for (const std::string& key : keys) options.erase(key);
    keys.insert(keys.end(), options.begin(), options.end());
    return keys;
}

/// What a filter of that key is compared with.
std::vector<std::string> values_of(const CaseInputs& inputs, std::string_view key) {
    if (key == "strategy") return {inputs.strategy.name, inputs.strategy.label};
    if (key == "label") return {inputs.strategy.label};
    if (key == "organ") return {inputs.organ.organ->name};
    if (key == "tool") return {inputs.tool.tool->name};
    if (key == "scene") return {inputs.scene.name};
    if (key == "speed") return {fmt::format("{}", inputs.speed)};
    if (key == "release") return {release_name(inputs.cycle.release)};
    if (key == "seed") return {fmt::format("{}", inputs.seed)};
    if (key == "rate") return {fmt::format("{}", inputs.cycle.rate)};
    if (key == "edge_stiffness") return {fmt::format("{}", inputs.springs.edge_stiffness)};
    if (key == "rest_stiffness") return {fmt::format("{}", inputs.springs.rest_stiffness)};
    const auto option = inputs.strategy.options.find(std::string(key));
    if (option == inputs.strategy.options.end()) return {};
    return {option_text(option->second)};
}

using Filters = std::map<std::string, std::vector<std::string>>;  // key → the values allowed

Filters parsed(std::span<const std::string> texts, const std::vector<std::string>& keys) {
    Filters filters;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) {
            throw InputError(fmt::format("--only {}: expected key=value, such as speed=100", text));
        }
        const std::string key = text.substr(0, equals);
        if (std::ranges::find(keys, key) == keys.end()) {
            throw InputError(fmt::format("--only {}: {}", text, unknown_name("key", key, keys)));
        }
        filters[key].push_back(text.substr(equals + 1));
    }
    return filters;
}

void check_value_exists(const std::vector<CaseInputs>& cases, const std::string& key,
                        const std::string& value) {
    std::set<std::string> known;
    for (const CaseInputs& inputs : cases) {
        for (std::string& one : values_of(inputs, key)) known.insert(std::move(one));
    }
    if (known.contains(value)) return;
    const std::vector<std::string> names(known.begin(), known.end());
    throw InputError(fmt::format("--only {}={}: {}", key, value, unknown_name(key, value, names)));
}

bool matches(const CaseInputs& inputs, const std::string& key, const std::vector<std::string>& allowed) {
    return std::ranges::any_of(values_of(inputs, key), [&](const std::string& value) {
        return std::ranges::find(allowed, value) != allowed.end();
    });
}

}  // namespace

std::vector<CaseInputs> only(std::vector<CaseInputs> cases, std::span<const std::string> filters) {
    for (const auto& filter : parsed(filters, filter_keys(cases))) {
        for (const std::string& value : filter.second) check_value_exists(cases, filter.first, value);
        std::erase_if(
            cases, [&](const CaseInputs& inputs) { return !matches(inputs, filter.first, filter.second); });
    }
    return cases;
}

}  // namespace trocar
