#include "experiments/cli/organ_argument.h"

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "common/geometry/organ_shapes.h"
#include "experiments/input_error.h"

namespace trocar {

OrganInput organ_of_argument(const std::string& text, const std::optional<double>& size) {
    if (std::filesystem::is_regular_file(text)) return read_organ(text, size);
    if (size) throw InputError("--size is for an organ from a mesh file");
    try {
        return {.organ = make_organ_by_formula(text), .findings = {}};
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("{}; there is no file of that name either", error.what()));
    }
}

}  // namespace trocar
