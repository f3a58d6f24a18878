#pragma once

#include <string>
#include <string_view>

namespace trocar {

/// @{
/// What this program was built from and how. Text that is not known is "unknown".
std::string_view git_commit();  ///< at the time of the build
bool git_dirty();               ///< the tree had changes that the commit does not hold
std::string_view program_version();
std::string_view compiler();
std::string_view compiler_flags();
std::string_view build_type();
std::string_view library_versions();  ///< "CGAL 5.5.2, FCL 0.7.0, …"
/// @}

/// Hash of the running program's bytes but for those that say which commit it is of: two results of the same
/// build_id were made by the same code. Throws InputError when the program cannot read itself.
std::string build_id();

}  // namespace trocar
