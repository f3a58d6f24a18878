#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "common/geometry/mesh_input.h"
#include "common/geometry/organ_shapes.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

OrganChoice make_choice(std::string identity, Organ&& organ, std::vector<Finding> findings) {
    auto shared = std::make_shared<const Organ>(std::move(organ));
    return {.identity = std::move(identity),
            .organ = shared,
            .queries = std::make_shared<const SurfaceQueries>(shared->rest),
            .judged = std::make_shared<const JudgedOrgan>(*shared),
            .findings = std::move(findings)};
}

OrganChoice from_formula(const ConfigValue& entry) {
    try {
        Organ organ = make_organ_by_formula(as_text(entry, "an organ"));
        std::string identity = organ.name;
        return make_choice(std::move(identity), std::move(organ), {});
    } catch (const std::invalid_argument& error) {
        throw PlacedError(entry.place, error.what());
    }
}

OrganChoice from_file(const ConfigTable& table, Place place, const std::filesystem::path& folder) {
    static const std::array<std::string, 2> keys{"file", "size"};
    check_keys(table, "key of an organ", keys);
    const ConfigValue* file_value = find(table, "file");
    if (file_value == nullptr) throw PlacedError(place, "an organ's table needs the key file");
    const std::filesystem::path file = mesh_file(*file_value, folder);
    std::optional<double> size;
    if (const ConfigValue* value = find(table, "size")) size = as_positive(*value, "size");
    OrganInput input = read_organ(file, size);
    std::string identity =
        fmt::format("{}, size {}", hash_of_file(file), size ? fmt::format("{}", *size) : "as it is");
    return make_choice(std::move(identity), std::move(input.organ), std::move(input.findings));
}

}  // namespace

std::filesystem::path mesh_file(const ConfigValue& file, const std::filesystem::path& folder) {
    std::filesystem::path path = folder / as_text(file, "file");
    if (std::filesystem::exists(path)) return path;
    throw PlacedError(file.place,
                      fmt::format("no file {}; paths are relative to the sweep file", path.string()));
}

OrganChoice read_organ_entry(const ConfigValue& entry, const std::filesystem::path& folder) {
    const auto* table = std::get_if<ConfigTable>(&entry.content);
    return table == nullptr ? from_formula(entry) : from_file(*table, entry.place, folder);
}

}  // namespace trocar
