#pragma once

#include <filesystem>

namespace trocar {

/// A file or folder that comes with the program: in share/trocar beside an installed one, or in the source
/// tree above the folder that it was built in. Throws InputError when it is in neither.
std::filesystem::path find_shipped(const std::filesystem::path& relative);

}  // namespace trocar
