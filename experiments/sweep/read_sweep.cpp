#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "experiments/input_error.h"
#include "experiments/sweep/config.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/hash.h"
#include "experiments/sweep/sweep.h"

namespace trocar {
namespace {

constexpr std::int64_t most_seeds = 1'000'000;

const ConfigValue& needed(const ConfigTable& table, std::string_view key) {
    const ConfigValue* value = find(table, key);
    if (value == nullptr) throw PlacedError(Place{}, fmt::format("the key {} is missing", key));
    return *value;
}

/// Reads every entry of the list under `key`; two entries of equal `name_of` are an error at the second one.
template <typename Read, typename NameOf>
auto read_list(const ConfigTable& table, std::string_view key, Read read, NameOf name_of) {
    std::vector<decltype(read(std::declval<const ConfigValue&>()))> all;
    for (const ConfigValue& entry : as_list(needed(table, key), key)) {
        auto one = read(entry);
        for (const auto& earlier : all) {
            if (name_of(earlier) != name_of(one)) continue;
            throw PlacedError(entry.place, fmt::format("{} lists {} twice", key, name_of(one)));
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::uint64_t read_seed(const ConfigValue& entry) {
    const std::int64_t seed = as_whole_number(entry, "a seed");
    if (seed < 1) throw PlacedError(entry.place, fmt::format("a seed must be at least 1, not {}", seed));
    return static_cast<std::uint64_t>(seed);
}

std::vector<std::uint64_t> read_seeds(const ConfigTable& table) {
    const ConfigValue& value = needed(table, "seeds");
    if (std::holds_alternative<ConfigList>(value.content)) {
        return read_list(table, "seeds", read_seed, std::identity());
    }
    const std::int64_t count = as_whole_number(value, "seeds");
    if (count < 1 || count > most_seeds) {
        throw PlacedError(value.place, fmt::format("seeds must be from 1 to {}, not {}", most_seeds, count));
    }
    std::vector<std::uint64_t> seeds(static_cast<std::size_t>(count));
    std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
    return seeds;
}

/// A label that two strategies share by default needs another message: the remedy is not to drop one of them.
void check_differs(const StrategyChoice& one, const StrategyChoice& earlier, Place place) {
    if (one.name == earlier.name && one.options == earlier.options) {
        throw PlacedError(place, fmt::format(R"(strategies lists {} twice with the same options: "{}", "{}")",
                                             one.name, earlier.label, one.label));
    }
    if (one.label == earlier.label) {
        throw PlacedError(place,
                          fmt::format("two strategies have the label \"{}\"; give each its own, such as "
                                      "label = \"{}, variant\"",
                                      one.label, one.name));
    }
}

std::vector<StrategyChoice> read_strategies(const ConfigTable& table, const std::filesystem::path& folder) {
    std::vector<StrategyChoice> strategies;
    for (const ConfigValue& entry : as_list(needed(table, "strategies"), "strategies")) {
        for (StrategyChoice& one : read_strategy_entry(entry, folder)) {
            for (const StrategyChoice& earlier : strategies) check_differs(one, earlier, entry.place);
            strategies.push_back(std::move(one));
        }
    }
    return strategies;
}

Sweep read_tables(const ConfigTable& table, std::string text, const std::filesystem::path& folder) {
    static const std::array<std::string, 10> keys{"name",   "strategies", "organs", "tools",       "scenes",
                                                  "speeds", "seeds",      "cycle",  "deformation", "compare"};
    static const ConfigTable no_table;
    check_keys(table, "key", keys);
    Sweep sweep;
    sweep.text = std::move(text);
    sweep.name = as_text(needed(table, "name"), "name");
    const auto organ_of = [&](const ConfigValue& entry) { return read_organ_entry(entry, folder); };
    const auto scene_of = [&](const ConfigValue& entry) { return read_scene_entry(entry, folder); };
    const auto tool_of = [&](const ConfigValue& entry) { return read_tool_entry(entry, folder); };
    const auto speed_of = [](const ConfigValue& entry) { return as_positive(entry, "a speed"); };
    sweep.strategies = read_strategies(table, folder);
    sweep.scenes = read_list(table, "scenes", scene_of, [](const SceneChoice& one) { return one.name; });
    sweep.speeds = read_list(table, "speeds", speed_of, std::identity());
    sweep.seeds = read_seeds(table);
    const ConfigValue* cycle_value = find(table, "cycle");
    const ConfigTable& cycle = cycle_value == nullptr ? no_table : as_table(*cycle_value, "cycle");
    sweep.cycle = read_cycle(cycle);
    sweep.rates = read_rates(cycle);
    sweep.releases = read_releases(cycle);
    const ConfigValue* material_value = find(table, "deformation");
    const ConfigTable& material =
        material_value == nullptr ? no_table : as_table(*material_value, "deformation");
    sweep.springs = read_springs(material);
    sweep.stiffnesses = read_stiffnesses(material);
    if (const ConfigValue* compare = find(table, "compare")) {
        sweep.same_state = read_same_state(as_table(*compare, "compare"));
    }
    sweep.tools = read_list(table, "tools", tool_of, [](const ToolChoice& one) { return one.tool->name; });
    sweep.organs =
        read_list(table, "organs", organ_of, [](const OrganChoice& one) { return one.organ->name; });
    return sweep;
}

}  // namespace

Sweep read_sweep(const std::filesystem::path& file) {
    std::string text = read_bytes(file);
    try {
        const ConfigTable table = parse_toml(text);
        return read_tables(table, std::move(text), file.parent_path());
    } catch (const PlacedError& error) {
        throw InputError(
            fmt::format("{}:{}:{}: {}", file.string(), error.place.line, error.place.column, error.what()));
    }
}

}  // namespace trocar
