#pragma once

#include <span>
#include <string>
#include <string_view>

namespace trocar {

/// The name most like `wrong` (fewest letters inserted, deleted or replaced; of equally near ones the first).
/// Empty when even that one shares less than half of its letters with it.
std::string_view nearest_name(std::string_view wrong, std::span<const std::string> names);

/// A sentence for a name that does not exist, such as
/// `unknown organ "shpere"; did you mean "sphere"? Known: sheet, sphere`.
std::string unknown_name(std::string_view kind, std::string_view wrong, std::span<const std::string> names);

}  // namespace trocar
