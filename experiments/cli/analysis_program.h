#pragma once

#include <string>
#include <vector>

namespace trocar {

/// Runs the analysis (`/usr/bin/python3 -m trocar_analysis` with these arguments) to its end, with our
/// streams. Throws InputError when it, or Python, is not installed.
/// @returns its exit code; 128 + the signal's number when a signal ended it
int run_analysis(const std::vector<std::string>& arguments);

}  // namespace trocar
