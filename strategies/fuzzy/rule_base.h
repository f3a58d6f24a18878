#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "strategies/fuzzy/membership.h"

namespace trocar::fuzzy {

/// What the rules look at, in the order of RuleBase::inputs.
enum class Input {
    collision_index,  ///< "I_C": of the facet (eq. 1), in [−1, 1]
    previous_P,       ///< "previous_P": I_P that the facet before left, in [0, 1]; 0 at the first facet
    previous_S,       ///< "previous_S": I_S likewise
    previous_E,       ///< "previous_E": I_E likewise
    first_facet,      ///< "C_1": 0 (YES) at a vertex's first facet, 1 (NO) at the others
};
inline constexpr std::array<std::string_view, 5> input_names = {"I_C", "previous_P", "previous_S",
                                                                "previous_E", "C_1"};
inline constexpr std::array<std::string_view, 3> output_names = {"I_P", "I_S", "I_E"};

/// A term of an input: a word, and what belongs to it.
struct InputTerm {
    std::string name;
    Membership membership;
};

/// A term of an output: a word, and the weight that it stands for, in [0, 1].
struct OutputTerm {
    std::string name;
    double weight;
};

/// I_P, I_S or I_E.
struct Output {
    std::vector<OutputTerm> terms;
    double otherwise = 0;  ///< the weight where no rule fires, in [0, 1]
};

/// "I_C is sliding", or "I_S is HIGH": numbers of a variable and of one of its terms.
struct Proposition {
    std::size_t variable, term;
};

/// All of `when` make it hold; then each of `then` does.
struct Rule {
    std::size_t line;  ///< of the file, from 1
    std::string text;  ///< as it stands there
    double weight = 1;
    std::vector<Proposition> when;  ///< of inputs
    std::vector<Proposition> then;  ///< of outputs
};

/// Table I of the paper, or what stands in its place: the fuzzy system from which I = (I_P, I_S, I_E) comes.
///
/// The kind of inference is fixed: zero-order Takagi–Sugeno. A rule is as strong as the product of its
/// propositions' degrees and its weight; a weight is the average of the terms that rules give it, each as
/// heavy as its rule is strong.
struct RuleBase {
    std::string name;
    std::array<std::vector<InputTerm>, input_names.size()> inputs;
    std::array<Output, output_names.size()> outputs;
    std::vector<Rule> rules;
};

/// Whether a number can be a weight: from 0 to 1, so not NaN.
inline bool is_weight(double number) { return number >= 0 && number <= 1; }

/// A weaker rule does not fire: its strength is rounding.
inline constexpr double weakest_strength = 1e-15;

}  // namespace trocar::fuzzy
