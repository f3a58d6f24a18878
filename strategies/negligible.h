#pragma once

#include "common/cycle/contact.h"

namespace trocar {

/// A shorter vector (mm) is rounding and names no direction: a millionth of the clearance.
inline double negligible_length(const Contact& contact) { return 1e-6 * contact.clearance; }

}  // namespace trocar
