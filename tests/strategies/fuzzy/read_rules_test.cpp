#include "strategies/fuzzy/read_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/strategies/fuzzy/paper_rules.h"

namespace trocar::fuzzy {
namespace {

TEST(ReadRules, ReadsTheRulesThatShip) {
    const RuleBase base = read_rules(shipped_rules());
    EXPECT_EQ(base.name, "feedback");
    EXPECT_EQ(base.rules.size(), 3U + 27U);
    EXPECT_EQ(base.inputs[0].at(1).name, "sliding");
    EXPECT_EQ(base.inputs[0].at(1).membership.curve, Curve::trapezoid);
    EXPECT_EQ(base.outputs[2].terms.at(2).name, "HIGH");
    EXPECT_EQ(base.outputs[2].terms.at(2).weight, 1);
    const Rule& second = base.rules.at(1);
    EXPECT_THAT(second.text, testing::StartsWith("if C_1 is YES and I_C is sliding then"));
    ASSERT_EQ(second.when.size(), 2U);
    EXPECT_EQ(second.when[1].variable, 0U);
    EXPECT_EQ(second.when[1].term, 1U);
    ASSERT_EQ(second.then.size(), 3U);
    EXPECT_EQ(second.then[1].variable, 1U);
    EXPECT_EQ(second.then[1].term, 2U);
}

/// The line of the rule base that ships in which a text stands for the first time.
std::size_t line_of(const std::string& part) {
    const std::string& text = shipped_rules();
    return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, text.find(part)), '\n'));
}

TEST(ReadRules, ARuleKnowsItsLine) {
    EXPECT_EQ(read_rules(shipped_rules()).rules.front().line, line_of("rule: if C_1"));
}

/// A change to the rule base that ships which makes it unusable.
struct Refusal {
    std::string name, from, to;
    std::vector<std::string> said;  ///< parts of the message
    std::string placed;             ///< the line has this in the rule base that ships; empty: where `from` is
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class ReadRulesRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(ReadRulesRefuses, WithLineAndReason) {
    const Refusal& refusal = GetParam();
    try {
        (void)read_rules(with(refusal.from, refusal.to));
        FAIL() << "no error";
    } catch (const RuleError& error) {
        EXPECT_EQ(error.line, line_of(refusal.placed.empty() ? refusal.from : refusal.placed))
            << error.what();
        for (const std::string& part : refusal.said) EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
}

const std::string sliding_rule = "I_C is sliding then I_P";

INSTANTIATE_TEST_SUITE_P(
    Changes, ReadRulesRefuses,
    testing::Values(
        Refusal{"no_colon", "conjunction: AlgebraicProduct", "conjunction", {"no colon"}, {}},
        Refusal{"hedge", sliding_rule, "I_C is very sliding then I_P", {"hedge \"very\""}, {}},
        Refusal{"not", sliding_rule, "I_C is not sliding then I_P", {"hedge \"not\""}, {}},
        Refusal{"any", sliding_rule, "I_C is any then I_P", {"hedge \"any\""}, {}},
        Refusal{"hedge_behind", sliding_rule + " is LOW", sliding_rule + " is very LOW", {"very"}, {}},
        Refusal{"or", "is YES and " + sliding_rule, "is YES or " + sliding_rule, {"\"or\"", "one rule"}, {}},
        Refusal{"minimum", "AlgebraicProduct", "Minimum", {"Minimum", "only AlgebraicProduct"}, {}},
        Refusal{"disjunction", "disjunction: none", "disjunction: Maximum", {"Maximum"}, {}},
        Refusal{"implication", "implication: none", "implication: Minimum", {"Minimum"}, {}},
        Refusal{"activation", "activation: General", "activation: First 1 0", {"First 1 0"}, {}},
        Refusal{"defuzzifier",
                "defuzzifier: WeightedAverage TakagiSugeno",
                "defuzzifier: Centroid 100",
                {"Centroid 100", "WeightedAverage"},
                {}},
        Refusal{"tsukamoto", "WeightedAverage TakagiSugeno", "WeightedAverage Tsukamoto", {"Tsukamoto"}, {}},
        Refusal{"aggregation", "aggregation: none", "aggregation: Maximum", {"Maximum"}, {}},
        Refusal{"curve", "penetration Ramp", "penetration Ramb", {"\"Ramb\"", "did you mean \"Ramp\""}, {}},
        Refusal{"bell", "penetration Ramp -0.4142 -1", "penetration Bell 0 1 2", {"\"Bell\""}, {}},
        Refusal{"no_number", "Ramp -0.4142 -1", "Ramp -0.4142 minus", {"\"minus\" is no finite number"}, {}},
        Refusal{"infinite", "Ramp -0.4142 -1", "Ramp -0.4142 -inf", {"finite"}, {}},
        Refusal{"too_few", "Ramp -0.4142 -1", "Ramp -1", {"has 2 numbers", "not 1"}, {}},
        Refusal{"too_many", "Ramp -0.4142 -1", "Ramp -0.4142 -1 1 1", {"has 2 numbers", "not 4"}, {}},
        Refusal{"height", "Ramp -0.4142 -1", "Ramp -0.4142 -1 1.5", {"height"}, {}},
        Refusal{"descending", "-1 -0.4142 0.4142 1", "-1 0.4142 -0.4142 1", {"must ascend"}, {}},
        Refusal{"level_ramp", "Ramp -0.4142 -1", "Ramp -1 -1", {"must differ"}, {}},
        Refusal{"only_a_name", "penetration Ramp -0.4142 -1", "penetration", {"a name, a curve"}, {}},
        Refusal{"odd_name", "term: penetration", "term: pene-tration", {"letters, digits and _"}, {}},
        Refusal{"same_term", "term: sliding", "term: penetration", {"already"}, {}},
        Refusal{"weight_range", "LOW Constant 0", "LOW Constant -0.1", {"from 0 to 1"}, {}},
        Refusal{"no_constant", "LOW Constant 0", "LOW Triangle 0 1 2", {"Constant"}, {}},
        Refusal{"default", "default: 0", "default: nan", {"default: nan", "from 0 to 1"}, {}},
        Refusal{"no_default", "  default: 0\n", "", {"needs a line \"default"}, "OutputVariable: I_P"},
        Refusal{"input_range", "range: -1 1", "range: -2 2", {"-1 1", "-2 2"}, {}},
        Refusal{
            "lock_range", "range: -1 1", "range: -1 1\n lock-range: maybe", {"maybe"}, "term: penetration"},
        Refusal{"disabled", "range: -1 1", "range: -1 1\n enabled: false", {"#"}, "term: penetration"},
        Refusal{"unknown_key", "range: -1 1", "rang: -1 1", {"rang", "did you mean \"range\""}, {}},
        Refusal{"key_twice", "range: -1 1", "range: -1 1\n range: -1 1", {"twice"}, "InputVariable: I_C"},
        Refusal{"unknown_input", "InputVariable: C_1", "InputVariable: C_2", {"C_2", "each once"}, {}},
        Refusal{"input_twice", "InputVariable: C_1", "InputVariable: I_C", {"each once"}, {}},
        Refusal{"unknown_output", "OutputVariable: I_S", "OutputVariable: I_X", {"I_X", "I_P, I_S, I_E"}, {}},
        Refusal{"unknown_term", sliding_rule, "I_C is slidin then I_P", {"slidin"}, {}},
        Refusal{
            "unknown_variable", "C_1 is YES and I_C is sliding", "C1 is YES and I_C is sliding", {"C1"}, {}},
        Refusal{"output_asked", sliding_rule, "I_S is LOW then I_P", {"before \"then\"", "I_C"}, {}},
        Refusal{"input_concluded",
                sliding_rule + " is LOW",
                "I_C is sliding then I_C is sliding",
                {"output variable", "I_C"},
                {}},
        Refusal{"no_then", sliding_rule, "I_C is sliding I_P", {"then"}, {}},
        Refusal{"rule_weight", "and I_E is LOW  #", "and I_E is LOW with 2  #", {"from 0 to 1"}, {}},
        Refusal{"rule_weight_word", "and I_E is LOW  #", "and I_E is LOW with q  #", {"q"}, {}},
        Refusal{"before_blocks", "Engine: feedback", "range: 0 1", {"before the first block"}, {}}),
    [](const testing::TestParamInfo<Refusal>& the) { return the.param.name; });

TEST(ReadRules, RefusesWhatEndsTooEarly) {
    const std::string& text = shipped_rules();
    const auto refused = [](const std::string& cut) {
        try {
            (void)read_rules(cut);
        } catch (const RuleError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(refused(""), testing::HasSubstr("I_C"));
    EXPECT_THAT(refused(text.substr(0, text.find("RuleBlock"))), testing::HasSubstr("RuleBlock"));
    EXPECT_THAT(refused(text.substr(0, text.find("OutputVariable: I_S"))), testing::HasSubstr("I_S"));
    EXPECT_THAT(refused(text.substr(0, text.find("  rule:"))), testing::HasSubstr("\"rule"));
}

TEST(ReadRules, EveryCutOfTheTextIsReadOrRefused) {
    for (std::size_t length = 0; length < shipped_rules().size(); length += 37) {
        try {
            (void)read_rules(shipped_rules().substr(0, length));
        } catch (const RuleError& error) {
            EXPECT_GE(error.line, 1U);
        }
    }
}

TEST(ReadRules, RefusesMoreTermsThanTheInferenceHolds) {
    std::string more;
    for (int k = 0; k < 60; ++k) more += "  term: t" + std::to_string(k) + " Ramp 0 1\n";
    try {
        (void)read_rules(with("  term: penetration", more + "  term: penetration"));
        FAIL() << "no error";
    } catch (const RuleError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("64"));
    }
}

TEST(ReadRules, StandsWindowsLineEndsAndSeveralRuleBlocks) {
    std::string text = with("  # Rule 6", "RuleBlock: more\n  conjunction: AlgebraicProduct\n  # Rule 6");
    std::string windows;
    for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const RuleBase base = read_rules(windows);
    EXPECT_EQ(base.rules.size(), 30U);
    EXPECT_NEAR(Inference(base).further(-1, {0.5, 0.5, 0.5}).penetration, 1, 1e-15);
}

}  // namespace
}  // namespace trocar::fuzzy
