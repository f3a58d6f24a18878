#include "strategies/fuzzy/rules_option.h"

#include "strategies/fuzzy/read_rules.h"

namespace trocar::fuzzy {

OptionSpec rules_option() {
    return {.name = "rules",
            .default_value = std::string(shipped_rules_name),
            .summary = "the rule base: the one that ships (trocar fuzzy rules prints it), or a file in FLL",
            .choices = {shipped_rules_name},
            .check_contents = [](const std::string& contents) { (void)read_rules(contents); }};
}

RuleBase rules_of(const Options& resolved) {
    const std::string& chosen = word(resolved, "rules");
    return read_rules(chosen == shipped_rules_name ? shipped_rules() : chosen);
}

}  // namespace trocar::fuzzy
