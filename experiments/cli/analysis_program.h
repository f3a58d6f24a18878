#pragma once

#include <string>
#include <vector>

namespace trocar {

/// Runs the analysis (`/usr/bin/python3 -m trocar_analysis` with these arguments) to its end, with our
/// streams. Throws InputError when it, or Python, is not installed, and when it crashes: the words behind
/// "--", the files that it read, are damaged then.
/// @returns its exit code, which is 3 for a bug in it; 128 + the signal's number when somebody ended it by a
/// signal
int run_analysis(const std::vector<std::string>& arguments);

}  // namespace trocar
