#include "experiments/cli/rules_file.h"

#include "experiments/sweep/option_file.h"
#include "strategies/fuzzy/read_rules.h"
#include "strategies/fuzzy/rules_option.h"

namespace trocar {

std::string rules_text(const std::string& name_or_file) {
    if (name_or_file == fuzzy::shipped_rules_name) return fuzzy::shipped_rules();
    return read_option_file(fuzzy::rules_option(), name_or_file);
}

fuzzy::RuleBase read_rules_file(const std::string& name_or_file) {
    return fuzzy::read_rules(rules_text(name_or_file));
}

}  // namespace trocar
