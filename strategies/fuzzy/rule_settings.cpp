#include "strategies/fuzzy/rule_settings.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/nearest_name.h"
#include "strategies/fuzzy/read_rules.h"
#include "strategies/fuzzy/rule_base.h"

namespace trocar::fuzzy {
namespace {

/// A line that a block may have.
struct Setting {
    std::string key;
    std::vector<std::string> allowed;  ///< its values; none: any, or they are looked at elsewhere
    std::string why;                   ///< other values are not understood
    bool needed = false;
    bool repeated = false;  ///< may stand there more than once
};

Setting free(const char* key) { return {.key = key, .allowed = {}, .why = {}}; }

Setting fixed(const char* key, std::vector<std::string> allowed, const char* why) {
    return {.key = key, .allowed = std::move(allowed), .why = why};
}

Setting needed(Setting setting) {
    setting.needed = true;
    return setting;
}

Setting repeated(Setting setting) {
    setting.repeated = true;
    return setting;
}

using Settings = std::vector<Setting>;

const Settings& settings_of(const std::string& kind) {
    static const Setting enabled = fixed("enabled", {"true"}, "to leave something out, put # before it");
    static const Setting description = free("description"), range = needed(free("range"));
    static const Setting lock_range = fixed("lock-range", {"true", "false"}, "it is a yes or no");
    static const Setting term = needed(repeated(free("term")));
    static const Setting average = needed(
        fixed("defuzzifier", {"WeightedAverage TakagiSugeno", "WeightedAverage", "WeightedAverage Automatic"},
              "a weight is the average of its terms by the strengths of the rules"));
    static const Setting product = needed(
        fixed("conjunction", {"AlgebraicProduct"}, "a rule is as strong as the product of its propositions"));
    static const Settings engine{description};
    static const Settings input{enabled, description, range, lock_range, term};
    static const Settings output{
        enabled,
        description,
        range,
        lock_range,
        fixed("aggregation", {"none"}, "rules are averaged, not united"),
        average,
        needed(free("default")),
        fixed("lock-previous", {"false"}, "what a facet left is the next one's input previous_P, _S, _E"),
        term};
    static const Settings rules{
        enabled,
        description,
        product,
        fixed("disjunction", {"none"}, "there is no \"or\"; write one rule for each side"),
        fixed("implication", {"none"}, "a term of a weight is a number, there is nothing to cut off"),
        fixed("activation", {"General"}, "every rule fires as strongly as it holds"),
        needed(repeated(free("rule")))};
    return kind == "Engine"           ? engine
           : kind == "InputVariable"  ? input
           : kind == "OutputVariable" ? output
                                      : rules;
}

const Statement* find(const Block& block, std::string_view key) {
    const auto found = std::ranges::find(block.statements, key, &Statement::key);
    return found == block.statements.end() ? nullptr : &*found;
}

void check_statement(const Statement& statement, const std::vector<Setting>& settings,
                     const std::string& kind) {
    const auto setting = std::ranges::find(settings, statement.key, &Setting::key);
    if (setting == settings.end()) {
        std::vector<std::string> names;
        for (const Setting& one : settings) names.push_back(one.key);
        throw RuleError(statement.line, unknown_name(fmt::format("key of {}:", kind), statement.key, names));
    }
    if (setting->allowed.empty() || std::ranges::count(setting->allowed, statement.value) != 0) return;
    throw RuleError(statement.line,
                    fmt::format("{}: {} is not understood, only {}: {}", statement.key, statement.value,
                                fmt::join(setting->allowed, " or "), setting->why));
}

/// "range: LOW HIGH" must be what the variable means.
void check_range(const Block& block) {
    const bool signed_input = block.opening.value == input_names[0];
    const double low = signed_input ? -1 : 0, high = 1;
    const Statement& range = *find(block, "range");
    double found_low = 2, found_high = 2;
    const char* const end = range.value.data() + range.value.size();
    const auto first = std::from_chars(range.value.data(), end, found_low);
    const char* second = first.ptr;
    while (second != end && *second == ' ') ++second;
    const auto last = std::from_chars(second, end, found_high);
    if (found_low == low && found_high == high && last.ptr == end) return;
    throw RuleError(range.line, fmt::format("the range of {} is {} {}, not {}", block.opening.value, low,
                                            high, range.value));
}

}  // namespace

void check_settings(const Block& block) {
    const std::string& kind = block.opening.key;
    const std::vector<Setting>& settings = settings_of(kind);
    for (const Statement& statement : block.statements) check_statement(statement, settings, kind);
    for (const Setting& setting : settings) {
        const auto count = std::ranges::count(block.statements, setting.key, &Statement::key);
        if (count == 0 && setting.needed) {
            throw RuleError(block.opening.line,
                            fmt::format("{} {} needs a line \"{}: {}\"", kind, block.opening.value,
                                        setting.key, setting.allowed.empty() ? "…" : setting.allowed[0]));
        }
        if (count > 1 && !setting.repeated) {
            throw RuleError(block.opening.line,
                            fmt::format("{} {} has \"{}\" twice", kind, block.opening.value, setting.key));
        }
    }
    if (find(block, "range") != nullptr) check_range(block);
}

double default_weight(const Block& block) {
    const Statement& statement = *find(block, "default");
    double weight = -1;
    const char* const end = statement.value.data() + statement.value.size();
    const auto [stopped, error] = std::from_chars(statement.value.data(), end, weight);
    if (error == std::errc() && stopped == end && is_weight(weight)) return weight;
    throw RuleError(statement.line, fmt::format("default: {} must be from 0 to 1: it is the weight of {} "
                                                "where no rule fires",
                                                statement.value, block.opening.value));
}

}  // namespace trocar::fuzzy
