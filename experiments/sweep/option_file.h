#pragma once

#include <filesystem>
#include <string>

#include "strategies/options.h"

namespace trocar {

/// What a file holds that an option is given (see OptionSpec::check_contents). Throws InputError, which names
/// the file, and the line of contents that cannot be used.
std::string read_option_file(const OptionSpec& option, const std::filesystem::path& file);

}  // namespace trocar
