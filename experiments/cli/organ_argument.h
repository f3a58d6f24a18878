#pragma once

#include <optional>
#include <string>

#include "common/geometry/mesh_input.h"

namespace trocar {

/// The organ that a command line names: a mesh file, or a formula. Throws InputError for a text that is
/// neither and for a size that is not for a file, and what read_organ throws.
/// @param size longest side of a mesh file, mm
OrganInput organ_of_argument(const std::string& text, const std::optional<double>& size);

}  // namespace trocar
