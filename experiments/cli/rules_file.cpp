#include "experiments/cli/rules_file.h"

#include <fmt/format.h>

#include "experiments/input_error.h"
#include "experiments/sweep/hash.h"
#include "strategies/fuzzy/read_rules.h"
#include "strategies/fuzzy/rules_option.h"

namespace trocar {

std::string rules_text(const std::string& name_or_file) {
    if (name_or_file == fuzzy::shipped_rules_name) return fuzzy::shipped_rules();
    std::string text = read_bytes(name_or_file);
    try {
        (void)fuzzy::read_rules(text);
    } catch (const fuzzy::RuleError& error) {
        throw InputError(fmt::format("{}:{}: {}", name_or_file, error.line, error.what()));
    }
    return text;
}

fuzzy::RuleBase read_rules_file(const std::string& name_or_file) {
    return fuzzy::read_rules(rules_text(name_or_file));
}

}  // namespace trocar
