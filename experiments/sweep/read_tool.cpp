#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "common/tool/tool_shapes.h"
#include "experiments/sweep/entries.h"

namespace trocar {
namespace {

/// What a tool's table states, key by key. A key that is not there leaves its number as it is.
class Parameters {
  public:
    /// @param kind such as "prism", in the message about a key that is not among `known`
    Parameters(const ConfigTable& table, std::string_view kind, std::vector<std::string> known)
        : table_(table) {
        known.emplace_back("shape");
        check_keys(table, fmt::format("parameter of a {}", kind), known);
    }

    void read(std::string_view key, double& number) const {
        if (const ConfigValue* value = find(table_, key)) number = as_positive(*value, key);
    }
    [[nodiscard]] int sides(Place place, std::string_view kind) const {
        const ConfigValue* value = find(table_, "sides");
        if (value == nullptr) throw PlacedError(place, fmt::format("a {} needs the key sides", kind));
        const std::int64_t sides = as_whole_number(*value, "sides");
        if (sides < fewest_sides || sides > most_sides) {
            throw PlacedError(value->place,
                              fmt::format("sides must be {} to {}, not {}", fewest_sides, most_sides, sides));
        }
        return static_cast<int>(sides);
    }

  private:
    const ConfigTable& table_;
};

Tool read_prism(const ConfigTable& table, Place place) {
    const Parameters given(table, "prism", {"sides", "radius", "length"});
    double radius = default_prism_radius, length = default_prism_length;
    given.read("radius", radius);
    given.read("length", length);
    return make_prism(given.sides(place, "prism"), radius, length);
}

Tool read_pointed_prism(const ConfigTable& table, Place place) {
    const Parameters given(table, "pointed-prism", {"sides", "radius", "length", "tip_length"});
    PointedPrismSize size;
    given.read("radius", size.radius);
    given.read("length", size.length);
    given.read("tip_length", size.tip_length);
    return make_pointed_prism(given.sides(place, "pointed-prism"), size);
}

Tool read_needle(const ConfigTable& table, Place) {
    const Parameters given(table, "needle", {"radius", "length", "tip_angle"});
    NeedleSize size;
    given.read("radius", size.radius);
    given.read("length", size.length);
    given.read("tip_angle", size.tip_angle);
    return make_needle(size);
}

Tool read_grasper(const ConfigTable& table, Place) {
    const Parameters given(table, "grasper", {"radius", "length", "jaw_length", "opening"});
    GrasperSize size;
    given.read("radius", size.radius);
    given.read("length", size.length);
    given.read("jaw_length", size.jaw_length);
    given.read("opening", size.opening);
    return make_grasper(size);
}

struct Shape {
    const char* name;
    Tool (*read)(const ConfigTable& table, Place place);
};
constexpr std::array shapes{Shape{"prism", read_prism}, Shape{"pointed-prism", read_pointed_prism},
                            Shape{"needle", read_needle}, Shape{"grasper", read_grasper}};

ToolChoice by_formula(Tool&& tool) {
    std::string identity = tool.name;
    return tool_choice(std::move(identity), std::move(tool), {});
}

ToolChoice from_shape(const ConfigTable& table, const ConfigValue& shape, Place place) {
    const std::string& name = as_text(shape, "shape");
    const auto* known = std::ranges::find(shapes, name, &Shape::name);
    if (known == shapes.end()) {
        std::vector<std::string> names;
        for (const Shape& one : shapes) names.emplace_back(one.name);
        throw PlacedError(shape.place, unknown_name("tool shape", name, names));
    }
    try {
        return by_formula(known->read(table, place));
    } catch (const std::invalid_argument& error) {
        throw PlacedError(shape.place, error.what());
    }
}

ToolChoice from_name(const ConfigValue& entry) {
    try {
        return by_formula(make_tool_by_formula(as_text(entry, "a tool")));
    } catch (const std::invalid_argument& error) {
        throw PlacedError(entry.place, error.what());
    }
}

}  // namespace

ToolChoice tool_choice(std::string identity, Tool&& tool, std::vector<Finding> findings) {
    auto shared = std::make_shared<const Tool>(std::move(tool));
    return {.identity = std::move(identity),
            .tool = shared,
            .judged = std::make_shared<const JudgedTool>(*shared),
            .findings = std::move(findings)};
}

ToolChoice read_tool_entry(const ConfigValue& entry, const std::filesystem::path& folder) {
    const auto* table = std::get_if<ConfigTable>(&entry.content);
    if (table == nullptr) return from_name(entry);
    if (const ConfigValue* file = find(*table, "file"))
        return read_tool_file(*table, *file, entry.place, folder);
    if (const ConfigValue* shape = find(*table, "shape")) return from_shape(*table, *shape, entry.place);
    throw PlacedError(entry.place, "a tool's table needs the key shape, such as shape = \"prism\", or file");
}

}  // namespace trocar
