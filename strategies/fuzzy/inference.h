#pragma once

#include <cstdint>
#include <vector>

#include "strategies/fuzzy/interaction.h"
#include "strategies/fuzzy/rule_base.h"

namespace trocar::fuzzy {

/// A rule base that has been laid out for speed: no strings, and no memory is asked for in an evaluation, so
/// that any number of threads may use one object at once. What C_1 decides is decided beforehand: there is
/// one table for a vertex's first facet and one for the others.
class Inference {
  public:
    /// The most terms that the inputs of a rule base may have together; read_rules sees to it.
    static constexpr std::size_t most_terms = 64;

    explicit Inference(const RuleBase& rules);

    /// I from a vertex's first facet (C_1 = YES). @param collision_index in [−1, 1]
    [[nodiscard]] Weights first(double collision_index) const;

    /// I from a further facet (C_1 = NO). @param previous what the facet before left, each in [0, 1]
    [[nodiscard]] Weights further(double collision_index, const Weights& previous) const;

  private:
    struct Term {
        std::size_t input;
        Membership membership;
    };
    struct Conclusion {
        std::uint32_t output;
        double weight;
    };
    struct FlatRule {
        double weight;
        std::uint32_t degrees_begin, degrees_end;  ///< of Table::degrees: its propositions
        std::uint32_t conclusions_begin, conclusions_end;
    };
    /// The rules that can fire for one value of C_1.
    struct Table {
        std::vector<Term> terms;  ///< that its rules ask for
        std::vector<FlatRule> rules;
        std::vector<std::uint32_t> degrees;  ///< numbers of `terms`
        std::vector<Conclusion> conclusions;
    };

    static Table table_of(const RuleBase& rules, double first_facet);
    [[nodiscard]] Weights evaluate(const Table& table, double collision_index, const Weights& previous) const;

    Table first_, further_;
    std::array<double, output_names.size()> otherwise_{};
};

}  // namespace trocar::fuzzy
