#include <algorithm>
#include <utility>

#include <toml++/toml.h>

#include "experiments/sweep/config.h"

namespace trocar {
namespace {

Place place_of(const toml::source_region& region) {
    return {.line = region.begin.line, .column = region.begin.column};
}

ConfigValue converted(const toml::node& node);

ConfigTable converted_table(const toml::table& table) {
    ConfigTable entries;
    for (const auto& [key, node] : table) {
        entries.push_back(
            {.key_place = place_of(key.source()), .key = std::string(key.str()), .value = converted(node)});
    }
    // toml++ sorts by key; errors are to name the first wrong key of the file.
    std::ranges::sort(entries, {}, [](const ConfigEntry& entry) {
        return std::pair(entry.key_place.line, entry.key_place.column);
    });
    return entries;
}

ConfigList converted_list(const toml::array& array) {
    ConfigList list;
    for (const toml::node& node : array) list.push_back(converted(node));
    return list;
}

ConfigValue converted(const toml::node& node) {
    const Place place = place_of(node.source());
    if (const auto* flag = node.as_boolean()) return {place, flag->get()};
    if (const auto* whole = node.as_integer()) return {place, whole->get()};
    if (const auto* number = node.as_floating_point()) return {place, number->get()};
    if (const auto* text = node.as_string()) return {place, text->get()};
    if (const auto* array = node.as_array()) return {place, converted_list(*array)};
    if (const auto* table = node.as_table()) return {place, converted_table(*table)};
    throw PlacedError(place, "a sweep has no dates or times");
}

}  // namespace

ConfigTable parse_toml(std::string_view text) {
    try {
        return converted_table(toml::parse(text));
    } catch (const toml::parse_error& error) {
        throw PlacedError(place_of(error.source()), std::string(error.description()));
    }
}

}  // namespace trocar
