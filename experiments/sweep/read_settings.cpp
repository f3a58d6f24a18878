#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "experiments/sweep/entries.h"

namespace trocar {
namespace {

struct NumberKey {
    std::string name;
    double* target;
};

void read_positive(const ConfigTable& table, const NumberKey& key) {
    if (const ConfigValue* value = find(table, key.name)) *key.target = as_positive(*value, key.name);
}

void read_not_negative(const ConfigTable& table, const NumberKey& key) {
    const ConfigValue* value = find(table, key.name);
    if (value == nullptr) return;
    *key.target = as_number(*value, key.name);
    if (*key.target < 0) throw PlacedError(value->place, fmt::format("{} must not be negative", key.name));
}

/// A positive number, or a list of different ones; `otherwise` without the key.
std::vector<double> read_one_or_several(const ConfigTable& table, const std::string& key, double otherwise) {
    const ConfigValue* value = find(table, key);
    if (value == nullptr) return {otherwise};
    if (!std::holds_alternative<ConfigList>(value->content)) return {as_positive(*value, key)};
    std::vector<double> numbers;
    for (const ConfigValue& entry : as_list(*value, key)) {
        const double number = as_positive(entry, key);
        if (std::ranges::find(numbers, number) != numbers.end())
            throw PlacedError(entry.place, fmt::format("{} lists {} twice", key, number));
        numbers.push_back(number);
    }
    return numbers;
}

Release read_release(const ConfigValue& value) {
    static const std::array<std::string, 2> words{"contact", "step"};
    const std::string& word = as_text(value, "release");
    if (word == words[0]) return Release::contact;
    if (word == words[1]) return Release::step;
    throw PlacedError(value.place, unknown_name("release", word, words));
}

}  // namespace

CycleSettings read_cycle(const ConfigTable& table) {
    static const std::array<std::string, 3> keys{"rate", "clearance", "release"};
    check_keys(table, "key of [cycle]", keys);
    CycleSettings settings;
    read_positive(table, {"clearance", &settings.clearance});
    return settings;
}

std::vector<double> read_rates(const ConfigTable& cycle) {
    return read_one_or_several(cycle, "rate", CycleSettings{}.rate);
}

std::vector<Release> read_releases(const ConfigTable& cycle) {
    const ConfigValue* value = find(cycle, "release");
    if (value == nullptr) return {CycleSettings{}.release};
    if (!std::holds_alternative<ConfigList>(value->content)) return {read_release(*value)};
    std::vector<Release> releases;
    for (const ConfigValue& entry : as_list(*value, "release")) {
        const Release release = read_release(entry);
        if (std::ranges::find(releases, release) != releases.end()) {
            throw PlacedError(entry.place, "release lists a word twice");
        }
        releases.push_back(release);
    }
    return releases;
}

int read_same_state(const ConfigTable& compare) {
    static const std::array<std::string, 1> keys{"same_state"};
    check_keys(compare, "key of [compare]", keys);
    const ConfigValue* value = find(compare, "same_state");
    if (value == nullptr) return 0;
    const std::int64_t states = as_whole_number(*value, "same_state");
    if (states < 0 || states > 1000) {
        throw PlacedError(value->place, fmt::format("same_state must be from 0 to 1000, not {}", states));
    }
    return static_cast<int>(states);
}

SpringSettings read_springs(const ConfigTable& table) {
    static const std::array<std::string, 7> keys{"density", "edge_stiffness", "rest_stiffness", "stiffness",
                                                 "damping", "substeps",       "sleep"};
    check_keys(table, "key of [deformation]", keys);
    SpringSettings settings;
    read_positive(table, {"density", &settings.density});
    read_positive(table, {"edge_stiffness", &settings.edge_stiffness});
    read_positive(table, {"rest_stiffness", &settings.rest_stiffness});
    read_not_negative(table, {"damping", &settings.damping});
    if (const ConfigValue* value = find(table, "substeps")) {
        const std::int64_t substeps = as_whole_number(*value, "substeps");
        if (substeps < 1 || substeps > 10'000) {
            throw PlacedError(value->place,
                              fmt::format("substeps must be from 1 to 10000, not {}", substeps));
        }
        settings.substeps = static_cast<int>(substeps);
    }
    if (const ConfigValue* value = find(table, "sleep")) settings.sleep = as_flag(*value, "sleep");
    return settings;
}

std::vector<double> read_stiffnesses(const ConfigTable& deformation) {
    return read_one_or_several(deformation, "stiffness", 1);
}

}  // namespace trocar
