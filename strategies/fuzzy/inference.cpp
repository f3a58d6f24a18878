#include "strategies/fuzzy/inference.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

namespace trocar::fuzzy {

/// Lays out the rules that can fire for one value of C_1.
class Inference::TableMaker {
  public:
    TableMaker(const RuleBase& rules, double first_facet) : rules_(rules), first_facet_(first_facet) {}

    Table make() {
        number_terms();
        for (const Rule& rule : rules_.rules) {
            if (strength_of(rule) >= weakest_strength) add(rule);
        }
        return std::move(table_);
    }

  private:
    static constexpr auto c_1 = static_cast<std::size_t>(Input::first_facet);

    /// The part of a rule's strength that does not change: its weight, and what it says of C_1.
    [[nodiscard]] double strength_of(const Rule& rule) const {
        double strength = rule.weight;
        for (const auto& [variable, term] : rule.when) {
            if (variable == c_1) strength *= degree(rules_.inputs[c_1][term].membership, first_facet_);
        }
        return strength;
    }

    static std::optional<StraightTerm> straight(std::size_t input, const Membership& membership) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const auto& [a, b, c, d] = membership.at;
        const auto between = [&](double from, double top, double end, double to) {
            return StraightTerm{input, from, 1 / (top - from), to, 1 / (to - end), membership.height};
        };
        if (membership.curve == Curve::ramp) {
            if (a < b) return StraightTerm{input, a, 1 / (b - a), infinity, 1, membership.height};
            return StraightTerm{input, -infinity, 1, a, 1 / (a - b), membership.height};
        }
        if (membership.curve == Curve::triangle && a < b && b < c) return between(a, b, b, c);
        if (membership.curve == Curve::trapezoid && a < b && c < d) return between(a, b, c, d);
        return std::nullopt;  // it jumps, or it is not straight
    }

    /// Straight terms come first, so that evaluation need not ask of each what it is.
    void number_terms() {
        std::vector<std::tuple<std::size_t, std::size_t>> curved;
        for (std::size_t input = 0; input < c_1; ++input) {
            numbers_[input].resize(rules_.inputs[input].size());
            for (std::size_t term = 0; term < numbers_[input].size(); ++term) {
                if (const auto line = straight(input, rules_.inputs[input][term].membership)) {
                    table_.straight.push_back(*line);
                    numbers_[input][term] = static_cast<std::uint32_t>(table_.straight.size());
                } else {
                    curved.emplace_back(input, term);
                }
            }
        }
        for (const auto& [input, term] : curved) {
            table_.curved.push_back({input, rules_.inputs[input][term].membership});
            numbers_[input][term] = static_cast<std::uint32_t>(table_.straight.size() + table_.curved.size());
        }
    }

    void add(const Rule& rule) {
        std::vector<std::uint32_t> degrees;
        for (const auto& [variable, term] : rule.when) {
            if (variable != c_1) degrees.push_back(numbers_[variable][term]);
        }
        degrees.resize(std::max<std::size_t>(degrees.size(), 2), 0);
        const auto begin = static_cast<std::uint32_t>(table_.more.size());
        table_.more.insert(table_.more.end(), degrees.begin() + 2, degrees.end());
        const auto end = static_cast<std::uint32_t>(table_.more.size());
        for (const auto& [output, term] : rule.then) {
            table_.conclusions[output].push_back({.strength = strength_of(rule),
                                                  .weight = rules_.outputs[output].terms[term].weight,
                                                  .one = degrees[0],
                                                  .other = degrees[1],
                                                  .more_begin = begin,
                                                  .more_end = end});
        }
    }

    const RuleBase& rules_;
    double first_facet_;
    std::array<std::vector<std::uint32_t>, c_1> numbers_;  // of each input's terms
    Table table_;
};

Inference::Inference(const RuleBase& rules)
    : first_(TableMaker(rules, 0).make()), further_(TableMaker(rules, 1).make()) {
    std::ranges::transform(rules.outputs, otherwise_.begin(), &Output::otherwise);
}

Weights Inference::first(double collision_index) const { return evaluate(first_, collision_index, {}); }

Weights Inference::further(double collision_index, const Weights& previous) const {
    return evaluate(further_, collision_index, previous);
}

Weights Inference::evaluate(const Table& table, double collision_index, const Weights& previous) const {
    const std::array<double, 4> inputs = {collision_index, previous.penetration, previous.sliding,
                                          previous.extraction};
    std::array<double, 1 + most_terms> degrees;  // set as far as there are terms
    double* next = degrees.data();
    *next++ = 1;
    for (const auto& [input, from, rise, to, fall, height] : table.straight) {
        const double x = inputs[input];
        *next++ = height * std::clamp(std::min((x - from) * rise, (to - x) * fall), 0.0, 1.0);
    }
    for (const auto& [input, membership] : table.curved) *next++ = degree(membership, inputs[input]);

    std::array<double, output_names.size()> weights = otherwise_;
    for (std::size_t output = 0; output < weights.size(); ++output) {
        double sum = 0, total = 0;
        for (const Conclusion& conclusion : table.conclusions[output]) {
            double strength = conclusion.strength * degrees[conclusion.one] * degrees[conclusion.other];
            for (std::uint32_t k = conclusion.more_begin; k < conclusion.more_end; ++k) {
                strength *= degrees[table.more[k]];
            }
            if (strength < weakest_strength) strength = 0;
            sum += strength * conclusion.weight;
            total += strength;
        }
        if (total > 0) weights[output] = sum / total;
    }
    return {.penetration = weights[0], .sliding = weights[1], .extraction = weights[2]};
}

}  // namespace trocar::fuzzy
