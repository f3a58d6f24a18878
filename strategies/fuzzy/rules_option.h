#pragma once

#include <string>

#include "strategies/fuzzy/rule_base.h"
#include "strategies/options.h"

namespace trocar::fuzzy {

/// The option `rules` of both fuzzy strategies: the rule base, one that ships or what a file holds.
OptionSpec rules_option();

/// The rule base that the option chooses. Throws RuleError.
RuleBase rules_of(const Options& resolved);

/// The rule base of the paper's method, rules/feedback.fll, as it was when the program was built.
const std::string& shipped_rules();

/// What `rules` is for it.
inline constexpr const char* shipped_rules_name = "feedback";

}  // namespace trocar::fuzzy
