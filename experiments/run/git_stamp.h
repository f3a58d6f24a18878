#pragma once

#include <string_view>

namespace trocar {

/// The one place of the program that differs from commit to commit: of a fixed length, it ends in the commit,
/// filled up with spaces, and "clean" or "dirty". Only where it is defined the compiler sees what it says, so
/// that no other code depends on it.
extern const std::string_view git_stamp;

}  // namespace trocar
