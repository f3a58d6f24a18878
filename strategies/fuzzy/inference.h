#pragma once

#include <array>
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
    /// A term whose membership rises straight from 0 at `from`, is cut off at 1, and falls straight to 0 at
    /// `to`; a side that it does not have is at infinity.
    struct StraightTerm {
        std::size_t input;
        double from, rise, to, fall, height;
    };
    /// Any other term.
    struct CurvedTerm {
        std::size_t input;
        Membership membership;
    };
    /// That a rule gives an output a weight. The rule is as strong as `strength` times the degrees of its
    /// propositions.
    struct Conclusion {
        double strength, weight;
        std::uint32_t one, other;  ///< numbers of degrees; degree 0 is 1
        std::uint32_t more_begin, more_end;
    };
    /// The rules that can fire for one value of C_1, laid out by output.
    struct Table {
        std::vector<StraightTerm> straight;  ///< degrees 1, 2, …
        std::vector<CurvedTerm> curved;      ///< … and those behind
        std::array<std::vector<Conclusion>, output_names.size()> conclusions;
        std::vector<std::uint32_t> more;  ///< degrees of rules with more than two propositions
    };
    class TableMaker;

    [[nodiscard]] Weights evaluate(const Table& table, double collision_index, const Weights& previous) const;

    Table first_, further_;
    std::array<double, output_names.size()> otherwise_{};
};

}  // namespace trocar::fuzzy
