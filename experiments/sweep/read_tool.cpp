#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "common/nearest_name.h"
#include "common/tool/tool_shapes.h"
#include "experiments/sweep/entries.h"

namespace trocar {
namespace {

double positive_or(const ConfigTable& table, std::string_view key, double otherwise) {
    const ConfigValue* value = find(table, key);
    return value == nullptr ? otherwise : as_positive(*value, key);
}

Tool read_prism(const ConfigTable& table, Place place) {
    static const std::array<std::string, 4> keys{"shape", "sides", "radius", "length"};
    check_keys(table, "parameter of a prism", keys);
    const ConfigValue* value = find(table, "sides");
    if (value == nullptr) throw PlacedError(place, "a prism needs the key sides");
    // A number beyond int is as wrong as one beyond the prism's range, and gets that message.
    const std::int64_t sides =
        std::clamp<std::int64_t>(as_whole_number(*value, "sides"), 0, std::numeric_limits<int>::max());
    const double radius = positive_or(table, "radius", default_prism_radius);
    const double length = positive_or(table, "length", default_prism_length);
    try {
        return make_prism(static_cast<int>(sides), radius, length);
    } catch (const std::invalid_argument& error) {
        throw PlacedError(value->place, error.what());
    }
}

Tool read_tool_table(const ConfigTable& table, Place place) {
    static const std::array<std::string, 1> shapes{"prism"};
    const ConfigValue* shape = find(table, "shape");
    if (shape == nullptr)
        throw PlacedError(place, "a tool's table needs the key shape, such as shape = \"prism\"");
    const std::string& name = as_text(*shape, "shape");
    if (name != shapes[0]) throw PlacedError(shape->place, unknown_name("tool shape", name, shapes));
    return read_prism(table, place);
}

Tool read_tool_name(const ConfigValue& entry) {
    try {
        return make_tool_by_formula(as_text(entry, "a tool"));
    } catch (const std::invalid_argument& error) {
        throw PlacedError(entry.place, error.what());
    }
}

}  // namespace

ToolChoice read_tool_entry(const ConfigValue& entry) {
    const auto* table = std::get_if<ConfigTable>(&entry.content);
    Tool tool = table == nullptr ? read_tool_name(entry) : read_tool_table(*table, entry.place);
    std::string identity = tool.name;
    return {.identity = std::move(identity),
            .tool = std::make_shared<const Tool>(std::move(tool)),
            .findings = {}};
}

}  // namespace trocar
