#include "strategies/fuzzy_inference.h"

#include <array>
#include <memory>
#include <string>

#include <fl/Headers.h>
#include <gtest/gtest.h>

namespace trocar::fuzzy {
namespace {

void expect_cases(const Cases& found, double penetration, double sliding, double extraction) {
    EXPECT_NEAR(found.penetration, penetration, 1e-12);
    EXPECT_NEAR(found.sliding, sliding, 1e-12);
    EXPECT_NEAR(found.extraction, extraction, 1e-12);
}

TEST(Memberships, NameThePureCases) {
    expect_cases(memberships(-1), 1, 0, 0);
    expect_cases(memberships(0), 0, 1, 0);
    expect_cases(memberships(1), 0, 0, 1);
}

TEST(Memberships, NeighbouringCasesWeighTheSameAt45Degrees) {
    expect_cases(memberships(-0.7071), 0.5, 0.5, 0);
    expect_cases(memberships(0.7071), 0, 0.5, 0.5);
}

TEST(Memberships, SumToOneAndMirror) {
    for (int k = -1000; k <= 1000; ++k) {
        const double c = k / 1000.0;
        const Cases at = memberships(c), mirrored = memberships(-c);
        EXPECT_NEAR(at.penetration + at.sliding + at.extraction, 1, 1e-15);
        EXPECT_EQ(at.penetration, mirrored.extraction);
        EXPECT_GE(at.sliding, 0);
    }
}

TEST(FirstPass, GivesHighToTheNamedCaseAndLowToTheOthers) {
    expect_cases(first_pass(-1), 1, 0, 0);
    expect_cases(first_pass(0.1), 0, 1, 0);
    expect_cases(first_pass(0.99), 0, 0.0082 / 0.2929 / 2 + 0.0018 / 0.5858, 1 - 0.01 / 0.5858);
}

TEST(Feedback, FollowsTheRuleTable) {
    // Penetration is named (evidence HIGH for P, LOW for S and E), from each previous term.
    expect_cases(feedback(-1, {0, 0, 0}), 0.5, 0, 0);
    expect_cases(feedback(-1, {0.5, 0.5, 0.5}), 1, 0, 0);
    expect_cases(feedback(-1, {1, 1, 1}), 1, 0.5, 0.5);
    // Sliding, and extraction.
    expect_cases(feedback(0, {0, 0, 1}), 0, 0.5, 0.5);
    expect_cases(feedback(1, {1, 0.5, 0}), 0.5, 0, 0.5);
}

TEST(Feedback, BetweenTermsIsTheirWeightedAverage) {
    // A quarter is half LOW, half MEDIUM: HIGH evidence gives (½ + 1) / 2, LOW evidence gives 0.
    expect_cases(feedback(-1, {0.25, 0.25, 0}), 0.75, 0, 0);
    // At 45° the evidence is half HIGH: (0.75 + 0) / 2.
    expect_cases(feedback(-0.7071, {0.25, 0.25, 0}), 0.375, 0.375, 0);
}

/// The same rules, written in fuzzylite's own language: an oracle that shares no code with ours.
class Fuzzylite {
  public:
    Fuzzylite() {
        fl::fuzzylite::setMachEps(1e-15);  // its default of 1e-6 blurs comparisons
        std::string text = "Engine: feedback\n" + input("index", -1, 1,
                                                        "  term: penetration Ramp -0.4142 -1.0\n"
                                                        "  term: sliding Trapezoid -1.0 -0.4142 0.4142 1.0\n"
                                                        "  term: extraction Ramp 0.4142 1.0\n");
        for (const char* name : {"P", "S", "E"})
            text += input(std::string("was_") + name, 0, 1, weight_terms);
        for (const char* name : {"P", "S", "E"}) text += output(name);
        text +=
            "RuleBlock: rule6\n  conjunction: AlgebraicProduct\n  disjunction: none\n  implication: none\n"
            "  activation: General\n";
        const std::array<std::pair<const char*, const char*>, 3> named = {
            {{"P", "penetration"}, {"S", "sliding"}, {"E", "extraction"}}};
        for (const auto& [weight, own] : named) {
            for (const auto& [other_weight, index] : named) {
                const bool evidence = std::string(index) == own;
                const std::array<const char*, 3> then =
                    evidence ? std::array{"medium", "high", "high"} : std::array{"low", "low", "medium"};
                const std::array was = {"low", "medium", "high"};
                for (std::size_t k = 0; k < 3; ++k) {
                    text += std::string("  rule: if index is ") + index + " and was_" + weight + " is " +
                            was[k] + " then " + weight + " is " + then[k] + "\n";
                }
            }
        }
        engine_.reset(fl::FllImporter().fromString(text));
    }

    Cases evaluate(double index, const Cases& previous) {
        engine_->setInputValue("index", index);
        engine_->setInputValue("was_P", previous.penetration);
        engine_->setInputValue("was_S", previous.sliding);
        engine_->setInputValue("was_E", previous.extraction);
        engine_->process();
        return {engine_->getOutputValue("P"), engine_->getOutputValue("S"), engine_->getOutputValue("E")};
    }

  private:
    static constexpr const char* weight_terms =
        "  term: low Triangle -0.5 0 0.5\n  term: medium Triangle 0 0.5 1\n  term: high Triangle 0.5 1 1.5\n";

    static std::string input(const std::string& name, int low, int high, const std::string& terms) {
        return "InputVariable: " + name + "\n  enabled: true\n  range: " + std::to_string(low) + " " +
               std::to_string(high) + "\n  lock-range: false\n" + terms;
    }
    static std::string output(const std::string& name) {
        return "OutputVariable: " + name +
               "\n  enabled: true\n  range: 0 1\n  lock-range: false\n  aggregation: none\n"
               "  defuzzifier: WeightedAverage TakagiSugeno\n  default: nan\n  lock-previous: false\n"
               "  term: low Constant 0\n  term: medium Constant 0.5\n  term: high Constant 1\n";
    }

    std::unique_ptr<fl::Engine> engine_;
};

TEST(Feedback, EqualsFuzzylite) {
    Fuzzylite oracle;
    for (int c = -20; c <= 20; ++c) {
        for (int previous = 0; previous <= 100; ++previous) {
            const Cases before = {previous / 100.0, (previous * 7 % 101) / 100.0,
                                  (previous * 31 % 101) / 100.0};
            const Cases ours = feedback(c / 20.0, before), theirs = oracle.evaluate(c / 20.0, before);
            ASSERT_NEAR(ours.penetration, theirs.penetration, 1e-12) << c << " " << previous;
            ASSERT_NEAR(ours.sliding, theirs.sliding, 1e-12) << c << " " << previous;
            ASSERT_NEAR(ours.extraction, theirs.extraction, 1e-12) << c << " " << previous;
        }
    }
}

}  // namespace
}  // namespace trocar::fuzzy
