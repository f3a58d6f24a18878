#include <array>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "common/tool/tool_input.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

Vec3 as_vector(const ConfigValue& value, std::string_view what) {
    const ConfigList& list = as_list(value, what);
    if (list.size() != 3) {
        throw PlacedError(value.place,
                          fmt::format("{} must have three numbers, x, y and z, not {}", what, list.size()));
    }
    return {as_number(list[0], what), as_number(list[1], what), as_number(list[2], what)};
}

std::string text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

}  // namespace

ToolChoice read_tool_file(const ConfigTable& table, const ConfigValue& file_value, Place place,
                          const std::filesystem::path& folder) {
    static const std::array<std::string, 5> keys{"file", "axis", "tip", "size", "name"};
    check_keys(table, "key of a tool from a file", keys);
    const std::filesystem::path file = mesh_file(file_value, folder);
    const ConfigValue* axis = find(table, "axis");
    if (axis == nullptr) {
        throw PlacedError(place,
                          "a tool from a file needs the key axis: the direction from its tip to its "
                          "handle, such as axis = [0, 0, 1]");
    }
    ToolPlacement placement{.axis = as_vector(*axis, "axis")};
    if (placement.axis.isZero(0)) throw PlacedError(axis->place, "axis must be a direction, not [0, 0, 0]");
    placement.axis.normalize();
    if (const ConfigValue* tip = find(table, "tip")) placement.tip = as_vector(*tip, "tip");
    if (const ConfigValue* size = find(table, "size")) placement.size = as_positive(*size, "size");
    ToolInput input = read_tool(file, placement);
    if (const ConfigValue* name = find(table, "name")) input.tool.name = as_text(*name, "name");
    std::string identity =
        fmt::format("{}, axis {}, tip {}, size {}", hash_of_file(file), text(placement.axis),
                    placement.tip ? text(*placement.tip) : "at the lowest point",
                    placement.size ? fmt::format("{}", *placement.size) : "as it is");
    return tool_choice(std::move(identity), std::move(input.tool), std::move(input.findings));
}

}  // namespace trocar
