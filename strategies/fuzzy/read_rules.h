#pragma once

#include <string_view>

#include "strategies/fuzzy/rule_base.h"
#include "strategies/options.h"

namespace trocar::fuzzy {

/// A rule base cannot be used.
struct RuleError : ContentsError {
    using ContentsError::ContentsError;
};

/// Reads a rule base in fuzzylite's language (FLL); rules/README.md tells what is understood. fuzzylite
/// parses it. What the inference cannot express is refused by name: hedges, `or`, norms other than the
/// product, defuzzifiers other than the weighted average, terms of other curves, other variables.
///
/// Throws RuleError. Safe on several threads; they wait for one another, for fuzzylite's parser is not.
RuleBase read_rules(std::string_view text);

}  // namespace trocar::fuzzy
