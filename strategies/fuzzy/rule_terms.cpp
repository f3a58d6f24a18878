#include "strategies/fuzzy/rule_terms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "strategies/fuzzy/read_rules.h"

namespace trocar::fuzzy {
namespace {

/// What fuzzylite calls a curve, how many numbers it has, and what must hold of them.
struct CurveKind {
    std::string name;
    Curve curve;
    std::size_t numbers;
    bool (*valid)(double a, double b, double c, double d);
    const char* condition;
};

const std::array<CurveKind, 8>& curve_kinds() {
    static const std::array<CurveKind, 8> all = {{
        {"Triangle", Curve::triangle, 3,
         [](double a, double b, double c, double) { return a <= b && b <= c && a < c; }, "must ascend"},
        {"Trapezoid", Curve::trapezoid, 4,
         [](double a, double b, double c, double d) { return a <= b && b <= c && c <= d && a < d; },
         "must ascend"},
        {"Ramp", Curve::ramp, 2, [](double a, double b, double, double) { return a != b; }, "must differ"},
        {"Rectangle", Curve::rectangle, 2, [](double a, double b, double, double) { return a <= b; },
         "must ascend"},
        {"SShape", Curve::s_shape, 2, [](double a, double b, double, double) { return a < b; },
         "must ascend"},
        {"ZShape", Curve::z_shape, 2, [](double a, double b, double, double) { return a < b; },
         "must ascend"},
        {"PiShape", Curve::pi_shape, 4,
         [](double a, double b, double c, double d) { return a < b && b <= c && c < d; }, "must ascend"},
        {"Gaussian", Curve::gaussian, 2, [](double, double b, double, double) { return b > 0; },
         "are a mean and a deviation above 0"},
    }};
    return all;
}

/// "NAME KIND NUMBERS", taken apart.
struct TermText {
    std::string name, kind;
    std::vector<double> numbers;
};

[[noreturn]] void refuse(const Statement& statement, const std::string& why) {
    throw RuleError(statement.line, fmt::format("term {}: {}", statement.value, why));
}

double number_of(const Statement& statement, const std::string& word) {
    double number = 0;
    const char* const end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || stopped != end || !std::isfinite(number)) {
        refuse(statement, fmt::format("\"{}\" is no finite number", word));
    }
    return number;
}

TermText text_of(const Statement& statement) {
    std::istringstream words(statement.value);
    TermText text;
    words >> text.name >> text.kind;
    if (text.kind.empty()) refuse(statement, "must be a name, a curve and its numbers");
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (!std::ranges::all_of(text.name, plain)) refuse(statement, "a name has letters, digits and _ only");
    for (std::string word; words >> word;) text.numbers.push_back(number_of(statement, word));
    return text;
}

const CurveKind& kind_of(const Statement& statement, const std::string& name) {
    const auto& kinds = curve_kinds();
    const auto* const kind = std::ranges::find(kinds, name, &CurveKind::name);
    if (kind != kinds.end()) return *kind;
    std::vector<std::string> names;
    for (const CurveKind& one : kinds) names.push_back(one.name);
    refuse(statement, unknown_name("curve", name, names));
}

InputTerm input_term(const Statement& statement) {
    const TermText text = text_of(statement);
    const CurveKind& kind = kind_of(statement, text.kind);
    const std::size_t count = text.numbers.size();
    if (count != kind.numbers && count != kind.numbers + 1) {
        refuse(statement, fmt::format("a {} has {} numbers, and perhaps a height behind them, not {}",
                                      kind.name, kind.numbers, count));
    }
    InputTerm term{.name = text.name, .membership = {.curve = kind.curve, .at = {}, .height = 1}};
    std::copy_n(text.numbers.begin(), kind.numbers, term.membership.at.begin());
    const auto& [a, b, c, d] = term.membership.at;
    if (!kind.valid(a, b, c, d)) {
        refuse(statement, fmt::format("the numbers of a {} {}", kind.name, kind.condition));
    }
    if (count > kind.numbers) term.membership.height = text.numbers.back();
    if (!is_weight(term.membership.height) || term.membership.height == 0) {
        refuse(statement, "its height must be above 0 and at most 1");
    }
    return term;
}

OutputTerm output_term(const Statement& statement) {
    const TermText text = text_of(statement);
    if (text.kind != "Constant" || text.numbers.size() != 1) {
        refuse(statement, "a term of a weight is a Constant with one number, such as \"HIGH Constant 1\"");
    }
    if (!is_weight(text.numbers[0])) refuse(statement, "a weight must be from 0 to 1");
    return {.name = text.name, .weight = text.numbers[0]};
}

template <typename Term>
std::vector<Term> terms_of(const Block& block, Term (*read)(const Statement&)) {
    std::vector<Term> terms;
    for (const Statement& statement : block.statements) {
        if (statement.key != "term") continue;
        Term term = read(statement);
        if (std::ranges::find(terms, term.name, &Term::name) != terms.end()) {
            refuse(statement, fmt::format("{} has this term already", block.opening.value));
        }
        terms.push_back(std::move(term));
    }
    if (terms.empty()) throw RuleError(block.opening.line, block.opening.value + " has no term");
    return terms;
}

}  // namespace

std::vector<InputTerm> input_terms(const Block& block) { return terms_of(block, input_term); }

std::vector<OutputTerm> output_terms(const Block& block) { return terms_of(block, output_term); }

}  // namespace trocar::fuzzy
