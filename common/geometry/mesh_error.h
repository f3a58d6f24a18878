#pragma once

#include <stdexcept>

namespace trocar {

/// A mesh file that cannot be used. The message says which file, where in it (file:line:column for text),
/// what was expected, what was found and what to do.
struct MeshError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace trocar
