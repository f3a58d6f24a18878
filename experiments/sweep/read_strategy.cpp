#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/sweep/cases.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/option_file.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

OptionValue option_value(const ConfigEntry& entry) {
    const ConfigValue& value = entry.value;
    if (const auto* flag = std::get_if<bool>(&value.content)) return *flag;
    if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
    return as_number(value, entry.key);
}

const Description& find_description(const ConfigValue& name) {
    try {
        return find_strategy(as_text(name, "a strategy's name")).description;
    } catch (const std::invalid_argument& unknown) {
        throw PlacedError(name.place, unknown.what());
    }
}

/// What the file holds that the value of an option names. Throws InputError, which names the file and the
/// line, where the option cannot take it.
std::string contents_of(const OptionSpec& option, const ConfigValue& value, const fs::path& folder) {
    const fs::path file = folder / as_text(value, option.name);
    if (!fs::exists(file)) {
        throw PlacedError(value.place,
                          fmt::format("{} is neither {} nor a file: there is no {}; paths are relative to "
                                      "the sweep file",
                                      option.name, fmt::join(option.choices, " nor "), file.string()));
    }
    return read_option_file(option, file);
}

/// The entry's value; where it names a file whose contents the option takes, the contents.
OptionValue loaded_value(const Description& strategy, const ConfigEntry& entry, const fs::path& folder) {
    const auto option = std::ranges::find(strategy.options, entry.key, &OptionSpec::name);
    const auto* text = std::get_if<std::string>(&entry.value.content);
    const bool takes_files = option != strategy.options.end() && option->check_contents != nullptr;
    if (!takes_files || text == nullptr || std::ranges::count(option->choices, *text) != 0) {
        return option_value(entry);
    }
    return contents_of(*option, entry.value, folder);
}

Options resolved(const Description& strategy, const ConfigTable& given, const fs::path& folder) {
    Options options;
    for (const ConfigEntry& entry : given) options[entry.key] = loaded_value(strategy, entry, folder);
    try {
        return resolve_options(strategy.options, options);
    } catch (const OptionError& error) {
        for (const ConfigEntry& entry : given) {
            if (entry.key != error.option) continue;
            const bool exists = std::ranges::any_of(
                strategy.options, [&](const OptionSpec& spec) { return spec.name == entry.key; });
            throw PlacedError(exists ? entry.value.place : entry.key_place, error.what());
        }
        throw;
    }
}

/// The values that an option is given: the one, or those of a list.
std::vector<ConfigValue> values_of(const ConfigEntry& option) {
    if (!std::holds_alternative<ConfigList>(option.value.content)) return {option.value};
    const ConfigList& values = as_list(option.value, option.key);
    std::vector<OptionValue> earlier;
    for (const ConfigValue& value : values) {
        if (std::holds_alternative<ConfigList>(value.content)) {
            throw PlacedError(value.place,
                              fmt::format("the list of {} holds a list; its values are tried one "
                                          "by one, write them without inner brackets",
                                          option.key));
        }
        OptionValue plain = option_value({option.key_place, option.key, value});
        if (std::ranges::find(earlier, plain) != earlier.end()) {
            throw PlacedError(value.place, fmt::format("{} lists {} twice", option.key, option_text(plain)));
        }
        earlier.push_back(std::move(plain));
    }
    return values;
}

/// One choice of values out of a table's lists.
struct Variant {
    ConfigTable options;  ///< without lists
    std::string label;    ///< the table's, then " option=value" for every list
};

/// Every variant with every value of one more option, whose values change fastest.
std::vector<Variant> multiplied(const std::vector<Variant>& variants, const ConfigEntry& option) {
    const bool is_list = std::holds_alternative<ConfigList>(option.value.content);
    const std::vector<ConfigValue> values = values_of(option);
    std::vector<Variant> product;
    for (const Variant& variant : variants) {
        for (const ConfigValue& value : values) {
            Variant& next = product.emplace_back(variant);
            const ConfigEntry& chosen = next.options.emplace_back(option.key_place, option.key, value);
            if (is_list) next.label += fmt::format(" {}={}", option.key, option_text(option_value(chosen)));
        }
    }
    return product;
}

}  // namespace

std::vector<StrategyChoice> read_strategy_entry(const ConfigValue& entry,
                                                const std::filesystem::path& folder) {
    if (!std::holds_alternative<ConfigTable>(entry.content)) {
        const Description& strategy = find_description(entry);
        return {{.name = strategy.name, .label = strategy.name, .options = resolved(strategy, {}, folder)}};
    }
    const ConfigTable& given = as_table(entry, "a strategy");
    const ConfigValue* name = find(given, "name");
    if (name == nullptr) throw PlacedError(entry.place, "a strategy's table needs the key name");
    const Description& strategy = find_description(*name);
    const ConfigValue* label = find(given, "label");
    std::vector<Variant> variants{
        {.options = {}, .label = label == nullptr ? strategy.name : as_text(*label, "label")}};
    for (const ConfigEntry& one : given) {
        if (one.key != "name" && one.key != "label") variants = multiplied(variants, one);
    }
    std::vector<StrategyChoice> choices;
    for (Variant& variant : variants) {
        choices.push_back({.name = strategy.name,
                           .label = std::move(variant.label),
                           .options = resolved(strategy, variant.options, folder)});
    }
    return choices;
}

}  // namespace trocar
