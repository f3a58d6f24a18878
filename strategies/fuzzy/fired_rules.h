#pragma once

#include <string>
#include <vector>

#include "strategies/fuzzy/interaction.h"
#include "strategies/fuzzy/rule_base.h"

namespace trocar::fuzzy {

/// What an evaluation is given: a facet's I_C, the weights before it, whether it is the first one.
struct Evidence {
    double collision_index;
    Weights previous;
    bool first;
};

/// How much a number belongs to one of an input's terms.
struct TermDegree {
    std::string term;
    double degree;
};

/// The degrees of all terms of an input. @param value of the input
std::vector<TermDegree> term_degrees(const RuleBase& rules, Input input, double value);

/// A rule and how strongly it fires.
struct FiredRule {
    const Rule* rule;
    double strength;  ///< the product of its propositions' degrees and its weight
};

/// The rules that fire, in their order: what Inference adds up, told for people.
std::vector<FiredRule> fired_rules(const RuleBase& rules, const Evidence& evidence);

}  // namespace trocar::fuzzy
