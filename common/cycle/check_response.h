#pragma once

#include <cstddef>

#include "common/cycle/contact.h"

namespace trocar {

/// Throws std::runtime_error when an answer is not finite, names a vertex that does not exist, or moves or
/// pushes a vertex twice.
/// @param vertices of the organ
void check_response(const Response& response, std::size_t vertices);

}  // namespace trocar
