#include "tests/strategies/variants.h"

namespace trocar {

std::vector<Variant> all_variants() {
    std::vector<Variant> variants;
    for (const StrategyEntry& entry : all_strategies()) {
        const Description& description = entry.description;
        variants.push_back({description.name, {}, description.name});
        const auto add = [&](const OptionSpec& spec, const OptionValue& value, const std::string& shown) {
            variants.push_back(
                {description.name, {{spec.name, value}}, description.name + "__" + spec.name + "_" + shown});
        };
        for (const OptionSpec& spec : description.options) {
            if (std::holds_alternative<bool>(spec.default_value)) {
                const bool other = !std::get<bool>(spec.default_value);
                add(spec, other, other ? "true" : "false");
            } else if (std::holds_alternative<double>(spec.default_value)) {
                add(spec, spec.low, "low");
                add(spec, spec.high, "high");
            } else {
                for (const std::string& choice : spec.choices) {
                    if (OptionValue(choice) != spec.default_value) add(spec, choice, choice);
                }
            }
        }
    }
    return variants;
}

}  // namespace trocar
