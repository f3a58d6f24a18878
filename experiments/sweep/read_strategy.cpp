#include "experiments/sweep/entries.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

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

Options resolved(const Description& strategy, const ConfigTable& given) {
    Options options;
    for (const ConfigEntry& entry : given) options[entry.key] = option_value(entry);
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

}  // namespace

StrategyChoice read_strategy_entry(const ConfigValue& entry) {
    if (!std::holds_alternative<ConfigTable>(entry.content)) {
        const Description& strategy = find_description(entry);
        return {.name = strategy.name, .label = strategy.name, .options = resolved(strategy, {})};
    }
    ConfigTable given = as_table(entry, "a strategy");
    const ConfigValue* name = find(given, "name");
    if (name == nullptr) throw PlacedError(entry.place, "a strategy's table needs the key name");
    const Description& strategy = find_description(*name);
    const ConfigValue* label = find(given, "label");
    StrategyChoice choice{.name = strategy.name,
                          .label = label == nullptr ? strategy.name : as_text(*label, "label"),
                          .options = {}};
    std::erase_if(given, [](const ConfigEntry& one) { return one.key == "name" || one.key == "label"; });
    choice.options = resolved(strategy, given);
    return choice;
}

}  // namespace trocar
