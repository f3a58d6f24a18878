// Our inference against fuzzylite's own evaluation of the same file.
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/strategies/fuzzy/fuzzylite_engine.h"
#include "tests/strategies/fuzzy/paper_rules.h"

namespace trocar::fuzzy {
namespace {

constexpr double agreement = 1e-12;

testing::AssertionResult agree(const Weights& ours, const Weights& theirs) {
    const double apart =
        std::max({std::abs(ours.penetration - theirs.penetration), std::abs(ours.sliding - theirs.sliding),
                  std::abs(ours.extraction - theirs.extraction)});
    if (apart <= agreement) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << fmt::format("ours ({}, {}, {}), fuzzylite's ({}, {}, {})", ours.penetration, ours.sliding,
                          ours.extraction, theirs.penetration, theirs.sliding, theirs.extraction);
}

void expect_agreement_on_a_grid(const std::string& rules) {
    const Inference inference(read_rules(rules));
    FuzzyliteEngine oracle(rules);
    for (int c = -500; c <= 500; ++c) {
        const double index = c / 500.0;
        ASSERT_TRUE(agree(inference.first(index), oracle.evaluate(index, {}, true))) << "I_C " << index;
    }
    std::vector<Weights> before;
    for (int p = 0; p <= 12; ++p) {
        for (int s = 0; s <= 12; ++s) {
            for (int e = 0; e <= 12; ++e) before.push_back({p / 12.0, s / 12.0, e / 12.0});
        }
    }
    for (int c = -20; c <= 20; ++c) {
        const double index = c / 20.0;
        for (const Weights& previous : before) {
            ASSERT_TRUE(agree(inference.further(index, previous), oracle.evaluate(index, previous, false)))
                << "I_C " << index << " after (" << previous.penetration << ", " << previous.sliding << ", "
                << previous.extraction << ")";
        }
    }
}

TEST(Fuzzylite, AgreesOnTheRulesThatShip) { expect_agreement_on_a_grid(shipped_rules()); }
TEST(Fuzzylite, AgreesOnSmoothCases) { expect_agreement_on_a_grid(smooth_rules()); }
TEST(Fuzzylite, AgreesOnCrispCases) { expect_agreement_on_a_grid(crisp_rules()); }

/// Writes rule bases at random.
class RandomRules {
  public:
    explicit RandomRules(unsigned seed) : generator_(seed) {}

    double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(generator_); }

    std::string text() {
        std::string text = "Engine: random\n";
        for (const char* name : {"I_C", "previous_P", "previous_S", "previous_E", "C_1"}) text += input(name);
        for (const char* name : {"I_P", "I_S", "I_E"}) text += output(name);
        for (int block = whole(1, 2); block > 0; --block) {
            text +=
                "RuleBlock:\n  conjunction: AlgebraicProduct\n  disjunction: none\n  implication: none\n"
                "  activation: General\n";
            for (int count = whole(3, 12); count > 0; --count) text += rule();
        }
        return text;
    }

  private:
    std::string input(const std::string& name) {
        const double low = name == "I_C" ? -1 : 0;
        std::string text = fmt::format("InputVariable: {}\n  range: {} 1\n", name, low);
        for (int term = 0; term < 3; ++term) text += fmt::format("  term: t{} {}\n", term, curve(low));
        return text;
    }

    std::string curve(double low) {
        std::array<double, 4> at{};
        for (double& x : at) x = number(low - 0.5, 1.5);
        std::ranges::sort(at);
        const auto& [a, b, c, d] = at;
        const std::string height = whole(0, 3) == 0 ? fmt::format(" {}", number(0.1, 1)) : "";
        switch (whole(0, 7)) {
            case 0:
                return fmt::format("Triangle {} {} {}{}", a, b, c, height);
            case 1:
                return fmt::format("Trapezoid {} {} {} {}{}", a, b, c, d, height);
            case 2:
                return fmt::format("Ramp {} {}{}", whole(0, 1) == 0 ? a : d, b, height);
            case 3:
                return fmt::format("Rectangle {} {}{}", a, c, height);
            case 4:
                return fmt::format("SShape {} {}{}", a, c, height);
            case 5:
                return fmt::format("ZShape {} {}{}", a, c, height);
            case 6:
                return fmt::format("PiShape {} {} {} {}{}", a, b, c, d, height);
            default:
                return fmt::format("Gaussian {} {}{}", b, number(0.1, 1), height);
        }
    }

    std::string output(const std::string& name) {
        std::string text = fmt::format(
            "OutputVariable: {}\n  range: 0 1\n  aggregation: none\n  defuzzifier: WeightedAverage "
            "TakagiSugeno\n  default: {}\n",
            name, number(0, 1));
        for (int term = 0; term < 3; ++term) {
            text += fmt::format("  term: t{} Constant {}\n", term, number(0, 1));
        }
        return text;
    }

    std::string rule() {
        std::string text = "  rule: if ";
        for (int count = whole(1, 4), k = 0; k < count; ++k) {
            const std::array<const char*, 5> names = {"I_C", "previous_P", "previous_S", "previous_E", "C_1"};
            text += fmt::format("{}{} is t{}", k == 0 ? "" : " and ", names.at(whole(0, 4)), whole(0, 2));
        }
        text += " then ";
        for (int count = whole(1, 3), k = 0; k < count; ++k) {
            const std::array<const char*, 3> names = {"I_P", "I_S", "I_E"};
            text += fmt::format("{}{} is t{}", k == 0 ? "" : " and ", names.at(whole(0, 2)), whole(0, 2));
        }
        return text + (whole(0, 2) == 0 ? fmt::format(" with {}\n", number(0, 1)) : "\n");
    }

    std::mt19937 generator_;
};

TEST(Fuzzylite, AgreesOnRandomRuleBases) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        RandomRules random(seed);
        const std::string text = random.text();
        const Inference inference(read_rules(text));
        FuzzyliteEngine oracle(text);
        for (int k = 0; k < 40; ++k) {
            const double index = random.number(-1, 1);
            const Weights previous = {random.number(0, 1), random.number(0, 1), random.number(0, 1)};
            ASSERT_TRUE(agree(inference.first(index), oracle.evaluate(index, {}, true)))
                << "seed " << seed << ", I_C " << index << "\n"
                << text;
            ASSERT_TRUE(agree(inference.further(index, previous), oracle.evaluate(index, previous, false)))
                << "seed " << seed << ", I_C " << index << "\n"
                << text;
        }
    }
}

}  // namespace
}  // namespace trocar::fuzzy
