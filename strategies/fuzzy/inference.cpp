#include "strategies/fuzzy/inference.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace trocar::fuzzy {

Inference::Inference(const RuleBase& rules) : first_(table_of(rules, 0)), further_(table_of(rules, 1)) {
    std::ranges::transform(rules.outputs, otherwise_.begin(), &Output::otherwise);
}

Inference::Table Inference::table_of(const RuleBase& rules, double first_facet) {
    Table table;
    constexpr auto c_1 = static_cast<std::size_t>(Input::first_facet);
    std::vector<Proposition> listed;  // of table.terms
    const auto number_of = [&](const Proposition& proposition) {
        const auto known = std::ranges::find_if(listed, [&](const Proposition& one) {
            return one.variable == proposition.variable && one.term == proposition.term;
        });
        const auto number = static_cast<std::uint32_t>(known - listed.begin());
        if (known == listed.end()) {
            listed.push_back(proposition);
            table.terms.push_back(
                {.input = proposition.variable,
                 .membership = rules.inputs[proposition.variable][proposition.term].membership});
        }
        return number;
    };
    for (const Rule& rule : rules.rules) {
        double weight = rule.weight;
        for (const auto& [variable, term] : rule.when) {
            if (variable == c_1) weight *= degree(rules.inputs[c_1][term].membership, first_facet);
        }
        if (weight < weakest_strength) continue;
        FlatRule flat{.weight = weight,
                      .degrees_begin = static_cast<std::uint32_t>(table.degrees.size()),
                      .degrees_end = 0,
                      .conclusions_begin = static_cast<std::uint32_t>(table.conclusions.size()),
                      .conclusions_end = 0};
        for (const Proposition& proposition : rule.when) {
            if (proposition.variable != c_1) table.degrees.push_back(number_of(proposition));
        }
        for (const auto& [variable, term] : rule.then) {
            table.conclusions.push_back({.output = static_cast<std::uint32_t>(variable),
                                         .weight = rules.outputs[variable].terms[term].weight});
        }
        flat.degrees_end = static_cast<std::uint32_t>(table.degrees.size());
        flat.conclusions_end = static_cast<std::uint32_t>(table.conclusions.size());
        table.rules.push_back(flat);
    }
    return table;
}

Weights Inference::first(double collision_index) const { return evaluate(first_, collision_index, {}); }

Weights Inference::further(double collision_index, const Weights& previous) const {
    return evaluate(further_, collision_index, previous);
}

Weights Inference::evaluate(const Table& table, double collision_index, const Weights& previous) const {
    const std::array<double, 4> inputs = {collision_index, previous.penetration, previous.sliding,
                                          previous.extraction};
    std::array<double, most_terms> degrees;  // as many as there are terms are set
    for (std::size_t k = 0; k < table.terms.size(); ++k) {
        degrees[k] = degree(table.terms[k].membership, inputs[table.terms[k].input]);
    }
    std::array<double, output_names.size()> sums{}, strengths{};
    for (const FlatRule& rule : table.rules) {
        double strength = rule.weight;
        for (std::uint32_t k = rule.degrees_begin; k < rule.degrees_end; ++k) {
            strength *= degrees[table.degrees[k]];
        }
        if (strength < weakest_strength) continue;
        for (std::uint32_t k = rule.conclusions_begin; k < rule.conclusions_end; ++k) {
            const Conclusion& conclusion = table.conclusions[k];
            sums[conclusion.output] += strength * conclusion.weight;
            strengths[conclusion.output] += strength;
        }
    }
    std::array<double, output_names.size()> weights = otherwise_;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        if (strengths[k] > 0) weights[k] = sums[k] / strengths[k];
    }
    return {.penetration = weights[0], .sliding = weights[1], .extraction = weights[2]};
}

}  // namespace trocar::fuzzy
