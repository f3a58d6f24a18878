#pragma once

#include <stdexcept>
#include <string>

namespace trocar {

/// Bad usage or input: the message says where (file, line, column), what was expected, what was found and
/// what to do. The program prints it and ends with exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace trocar
