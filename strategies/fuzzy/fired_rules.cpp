#include "strategies/fuzzy/fired_rules.h"

namespace trocar::fuzzy {

std::vector<TermDegree> term_degrees(const RuleBase& rules, Input input, double value) {
    std::vector<TermDegree> degrees;
    for (const InputTerm& term : rules.inputs.at(static_cast<std::size_t>(input))) {
        degrees.push_back({.term = term.name, .degree = degree(term.membership, value)});
    }
    return degrees;
}

std::vector<FiredRule> fired_rules(const RuleBase& rules, const Evidence& evidence) {
    const std::array<double, input_names.size()> values = {
        evidence.collision_index, evidence.previous.penetration, evidence.previous.sliding,
        evidence.previous.extraction, evidence.first ? 0.0 : 1.0};
    std::vector<FiredRule> fired;
    for (const Rule& rule : rules.rules) {
        double strength = rule.weight;
        for (const auto& [variable, term] : rule.when) {
            strength *= degree(rules.inputs.at(variable).at(term).membership, values.at(variable));
        }
        if (strength >= weakest_strength) fired.push_back({.rule = &rule, .strength = strength});
    }
    return fired;
}

}  // namespace trocar::fuzzy
