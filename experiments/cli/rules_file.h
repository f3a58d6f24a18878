#pragma once

#include <string>

#include "strategies/fuzzy/rule_base.h"

namespace trocar {

/// The text of a rule base: of the one that ships for its name, "feedback", otherwise of the file. Throws
/// InputError, which names file and line, for a file that is not there or no rule base.
std::string rules_text(const std::string& name_or_file);

/// The rule base itself. Throws as rules_text.
fuzzy::RuleBase read_rules_file(const std::string& name_or_file);

}  // namespace trocar
