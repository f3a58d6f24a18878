#include "experiments/sweep/config.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "common/nearest_name.h"

namespace trocar {
namespace {

// In the order of ConfigValue's variant.
constexpr std::array<std::string_view, 6> kind_names{"a flag (true or false)", "a whole number", "a number",
                                                     "a text in quotes",       "a list",         "a table"};

[[noreturn]] void refuse_kind(const ConfigValue& value, std::string_view what, std::string_view expected) {
    throw PlacedError(value.place, fmt::format("{} must be {}, not {}", what, expected,
                                               kind_names.at(value.content.index())));
}

template <typename Kind>
const Kind& as(const ConfigValue& value, std::string_view what, std::string_view expected) {
    const Kind* content = std::get_if<Kind>(&value.content);
    if (content == nullptr) refuse_kind(value, what, expected);
    return *content;
}

}  // namespace

const ConfigValue* find(const ConfigTable& table, std::string_view key) {
    const auto entry = std::ranges::find(table, key, &ConfigEntry::key);
    return entry == table.end() ? nullptr : &entry->value;
}

void check_keys(const ConfigTable& table, std::string_view kind, std::span<const std::string> known) {
    for (const ConfigEntry& entry : table) {
        if (std::ranges::find(known, entry.key) == known.end()) {
            throw PlacedError(entry.key_place, unknown_name(kind, entry.key, known));
        }
    }
}

const std::string& as_text(const ConfigValue& value, std::string_view what) {
    const auto& text = as<std::string>(value, what, "a text in quotes");
    if (text.empty()) throw PlacedError(value.place, fmt::format("{} is empty", what));
    // They would split the rows of tables, or command the reader's terminal.
    if (std::ranges::any_of(text, [](unsigned char c) { return c < ' ' || c == 127; }))
        throw PlacedError(value.place, fmt::format("{} has a control character, such as a line break", what));
    return text;
}

bool as_flag(const ConfigValue& value, std::string_view what) {
    return as<bool>(value, what, "true or false");
}

double as_number(const ConfigValue& value, std::string_view what) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.content)) return static_cast<double>(*whole);
    const double number = as<double>(value, what, "a number");
    if (!std::isfinite(number)) throw PlacedError(value.place, fmt::format("{} must be finite", what));
    return number;
}

std::int64_t as_whole_number(const ConfigValue& value, std::string_view what) {
    return as<std::int64_t>(value, what, "a whole number");
}

const ConfigList& as_list(const ConfigValue& value, std::string_view what) {
    const auto& list = as<ConfigList>(value, what, "a list in brackets");
    if (list.empty()) throw PlacedError(value.place, fmt::format("{} must have at least one entry", what));
    return list;
}

const ConfigTable& as_table(const ConfigValue& value, std::string_view what) {
    return as<ConfigTable>(value, what, "a table");
}

double as_positive(const ConfigValue& value, std::string_view what) {
    const double number = as_number(value, what);
    if (number <= 0) throw PlacedError(value.place, fmt::format("{} must be above 0, not {}", what, number));
    return number;
}

}  // namespace trocar
