#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trocar {

/// A place in a text file, counted from 1.
struct Place {
    std::int64_t line = 1;
    std::int64_t column = 1;
};

/// Something is wrong at a place of the file that is being read. read_sweep adds the file's name.
struct PlacedError : std::runtime_error {
    PlacedError(Place at, const std::string& message) : std::runtime_error(message), place(at) {}
    Place place;
};

struct ConfigValue;
struct ConfigEntry;
/// A list of a TOML file.
using ConfigList = std::vector<ConfigValue>;
/// A table of a TOML file, in the file's order.
using ConfigTable = std::vector<ConfigEntry>;

/// A value of a TOML file that remembers where it stands. Tables keep the order of the file.
struct ConfigValue {
    Place place;
    std::variant<bool, std::int64_t, double, std::string, ConfigList, ConfigTable> content;
};

/// A key of a table, and its value.
struct ConfigEntry {
    Place key_place;
    std::string key;
    ConfigValue value;
};

/// Parses TOML text. Throws PlacedError at a syntax error and at a date or time, which no sweep has.
ConfigTable parse_toml(std::string_view text);

/// The entry of that key, or nullptr.
const ConfigValue* find(const ConfigTable& table, std::string_view key);

/// Throws PlacedError at the first key that is not in `known`, naming the nearest one. `kind` says what the
/// key names, such as "option of fuzzy-per-vertex".
void check_keys(const ConfigTable& table, std::string_view kind, std::span<const std::string> known);

/// @{
/// The content of a value of the expected kind. `what` names the value in the PlacedError that another kind
/// is answered with, such as "speeds".
const std::string& as_text(const ConfigValue& value, std::string_view what);
bool as_flag(const ConfigValue& value, std::string_view what);
double as_number(const ConfigValue& value, std::string_view what);  ///< whole numbers too; finite
std::int64_t as_whole_number(const ConfigValue& value, std::string_view what);
const ConfigList& as_list(const ConfigValue& value, std::string_view what);  ///< with at least one element
const ConfigTable& as_table(const ConfigValue& value, std::string_view what);
/// @}

/// as_number, above zero.
double as_positive(const ConfigValue& value, std::string_view what);

}  // namespace trocar
