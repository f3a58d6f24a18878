#pragma once

#include "strategies/fuzzy/statements.h"

namespace trocar::fuzzy {

/// Throws RuleError for a setting of the block that the inference does not have, or that is set to what it
/// cannot do, and for one that is missing where fuzzylite's own default would be something else.
void check_settings(const Block& block);

/// The weight that an output block gives where no rule fires, from 0 to 1. Throws RuleError.
double default_weight(const Block& block);

}  // namespace trocar::fuzzy
