#include "strategies/fuzzy/read_rules.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <span>

#include <fl/Headers.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "strategies/fuzzy/inference.h"
#include "strategies/fuzzy/rule_settings.h"
#include "strategies/fuzzy/rule_terms.h"
#include "strategies/fuzzy/statements.h"

namespace trocar::fuzzy {
namespace {

/// fuzzylite loses what it has built of a rule that it then refuses: a hundred bytes, which LeakSanitizer is
/// not to report.
struct ForgiveLeaks {
#ifdef __SANITIZE_ADDRESS__
    __lsan::ScopedDisabler disabled;
#endif
};

/// fuzzylite's message without the tag in front and the place in its source behind.
std::string reason_of(const std::exception& error) {
    std::string reason = error.what();
    reason = reason.substr(0, reason.find('\n'));
    if (reason.starts_with('[')) reason.erase(0, std::min(reason.find("] ") + 2, reason.size()));
    return reason;
}

std::vector<Statement> statements_of(const std::vector<Block>& blocks) {
    std::vector<Statement> all;
    for (const Block& block : blocks) {
        all.push_back(block.opening);
        all.insert(all.end(), block.statements.begin(), block.statements.end());
    }
    return all;
}

std::unique_ptr<fl::Engine> parse(std::span<const Statement> statements) {
    std::string text;
    for (const Statement& one : statements) text += fmt::format("{}: {}\n", one.key, one.value);
    return std::unique_ptr<fl::Engine>(fl::FllImporter().fromString(text));
}

/// What fuzzylite makes of the statements. It does not say at which line it stumbles: that is the last line
/// of the shortest beginning that it stumbles at.
std::unique_ptr<fl::Engine> parse_placed(const std::vector<Statement>& statements) {
    try {
        return parse(statements);
    } catch (const fl::Exception&) {
        for (std::size_t count = 1; count <= statements.size(); ++count) {
            try {
                (void)parse(std::span(statements).first(count));
            } catch (const fl::Exception& error) {
                throw RuleError(statements[count - 1].line, reason_of(error));
            }
        }
        throw;
    }
}

/// A proposition in our numbers. `terms_of` gives the terms of the variable of a number.
template <typename TermsOf>
Proposition proposition_of(const fl::Proposition& proposition, std::span<const std::string_view> variables,
                           TermsOf terms_of, const Statement& rule, std::string_view part) {
    if (!proposition.hedges.empty()) {
        throw RuleError(rule.line,
                        fmt::format(R"(the hedge "{}" is not understood: write "VARIABLE is TERM")",
                                    proposition.hedges.front()->name()));
    }
    const std::string variable = proposition.variable->getName(), term = proposition.term->getName();
    const auto found = std::ranges::find(variables, variable);
    if (found == variables.end()) {
        throw RuleError(rule.line, fmt::format("{} stands {}, where a rule names {}", variable, part,
                                               fmt::join(variables, ", ")));
    }
    const auto number = static_cast<std::size_t>(found - variables.begin());
    const auto& terms = terms_of(number);
    const auto named = std::ranges::find_if(terms, [&](const auto& one) { return one.name == term; });
    return {.variable = number, .term = static_cast<std::size_t>(named - terms.begin())};
}

/// The propositions that an antecedent joins with "and", from left to right.
void collect(const fl::Expression& expression, const Statement& rule,
             std::vector<const fl::Proposition*>& all) {
    if (expression.type() == fl::Expression::Proposition) {
        all.push_back(dynamic_cast<const fl::Proposition*>(&expression));
        return;
    }
    const auto& joint = dynamic_cast<const fl::Operator&>(expression);
    if (joint.name != fl::Rule::andKeyword()) {
        throw RuleError(rule.line,
                        fmt::format("\"{}\" is not understood: write one rule for each side", joint.name));
    }
    collect(*joint.left, rule, all);
    collect(*joint.right, rule, all);
}

Rule rule_of(fl::Rule& parsed, fl::Engine& engine, const RuleBase& base, const Statement& statement) {
    try {
        if (!parsed.isLoaded()) parsed.load(&engine);  // the importer logs what is wrong, and goes on
    } catch (const fl::Exception& error) {
        throw RuleError(statement.line, reason_of(error));
    }
    Rule rule{.line = statement.line,
              .text = statement.value,
              .weight = parsed.getWeight(),
              .when = {},
              .then = {}};
    if (!is_weight(rule.weight)) {
        throw RuleError(statement.line, "the weight of a rule, behind \"with\", must be from 0 to 1");
    }
    std::vector<const fl::Proposition*> when;
    collect(*parsed.getAntecedent()->getExpression(), statement, when);
    for (const fl::Proposition* one : when) {
        const auto terms = [&](std::size_t k) -> const auto& { return base.inputs.at(k); };
        rule.when.push_back(proposition_of(*one, input_names, terms, statement, "before \"then\""));
    }
    for (const fl::Proposition* one : parsed.getConsequent()->conclusions()) {
        const auto terms = [&](std::size_t k) -> const auto& { return base.outputs.at(k).terms; };
        rule.then.push_back(proposition_of(*one, output_names, terms, statement, "behind \"then\""));
    }
    return rule;
}

/// Which of `names` the block describes; a rule base describes each once.
std::size_t place_of(const Block& block, std::span<const std::string_view> names, std::vector<bool>& seen) {
    const auto found = std::ranges::find(names, block.opening.value);
    const auto number = static_cast<std::size_t>(found - names.begin());
    if (found == names.end() || seen[number]) {
        throw RuleError(block.opening.line,
                        fmt::format("{} \"{}\": a rule base has {}, each once", block.opening.key,
                                    block.opening.value, fmt::join(names, ", ")));
    }
    seen[number] = true;
    return number;
}

void check_complete(std::span<const std::string_view> names, const std::vector<bool>& seen,
                    std::string_view kind, std::size_t last_line) {
    const auto missing = std::ranges::find(seen, false);
    if (missing == seen.end()) return;
    throw RuleError(last_line, fmt::format("the rule base ends without \"{}: {}\"", kind,
                                           names[static_cast<std::size_t>(missing - seen.begin())]));
}

/// Name, variables and terms; everything but the rules.
RuleBase variables_of(const std::vector<Block>& blocks, std::size_t last_line) {
    RuleBase base;
    std::vector<bool> inputs(input_names.size()), outputs(output_names.size());
    std::size_t terms = 0;
    for (const Block& block : blocks) {
        const std::string& kind = block.opening.key;
        if (kind == "InputVariable") {
            auto& input = base.inputs.at(place_of(block, input_names, inputs));
            check_settings(block);
            input = input_terms(block);
            terms += input.size();
        } else if (kind == "OutputVariable") {
            Output& output = base.outputs.at(place_of(block, output_names, outputs));
            check_settings(block);
            output = {.terms = output_terms(block), .otherwise = default_weight(block)};
        } else {
            check_settings(block);
            if (kind == "Engine") base.name = block.opening.value;
        }
        if (terms > Inference::most_terms) {
            throw RuleError(block.opening.line,
                            fmt::format("the inputs have more than {} terms", Inference::most_terms));
        }
    }
    check_complete(input_names, inputs, "InputVariable", last_line);
    check_complete(output_names, outputs, "OutputVariable", last_line);
    return base;
}

/// The rules of all blocks, in the order of the text.
std::vector<Rule> rules_of(const std::vector<Block>& blocks, const RuleBase& base, std::size_t last_line) {
    const std::unique_ptr<fl::Engine> engine = parse_placed(statements_of(blocks));
    std::vector<Rule> rules;
    int rule_blocks = 0;
    for (const Block& block : blocks) {
        if (block.opening.key != "RuleBlock") continue;
        const fl::RuleBlock& parsed = *engine->getRuleBlock(rule_blocks++);
        std::size_t number = 0;
        for (const Statement& statement : block.statements) {
            if (statement.key != "rule") continue;
            rules.push_back(rule_of(*parsed.getRule(number++), *engine, base, statement));
        }
    }
    if (rules.empty()) throw RuleError(last_line, "the rule base ends without \"RuleBlock:\" and a rule");
    return rules;
}

}  // namespace

RuleBase read_rules(std::string_view text) {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    [[maybe_unused]] const ForgiveLeaks forgive_leaks{};
    fl::fuzzylite::setLogging(false);
    const std::vector<Block> blocks = blocks_of(text);
    const auto last_line = static_cast<std::size_t>(1 + std::ranges::count(text, '\n'));
    RuleBase base = variables_of(blocks, last_line);
    base.rules = rules_of(blocks, base, last_line);
    return base;
}

}  // namespace trocar::fuzzy
