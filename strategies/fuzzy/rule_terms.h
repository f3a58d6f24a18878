#pragma once

#include "strategies/fuzzy/rule_base.h"
#include "strategies/fuzzy/statements.h"

namespace trocar::fuzzy {

/// The terms of an input: "term: NAME CURVE NUMBERS", perhaps with the curve's height behind. Throws
/// RuleError.
std::vector<InputTerm> input_terms(const Block& block);

/// The terms of an output: "term: NAME Constant WEIGHT". Throws RuleError.
std::vector<OutputTerm> output_terms(const Block& block);

}  // namespace trocar::fuzzy
