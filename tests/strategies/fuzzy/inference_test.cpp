#include "strategies/fuzzy/inference.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/random_numbers.h"
#include "tests/strategies/fuzzy/paper_rules.h"

namespace trocar::fuzzy {
namespace {

using testing_support::random_number;

void expect_weights(const Weights& found, double penetration, double sliding, double extraction) {
    EXPECT_NEAR(found.penetration, penetration, 1e-12);
    EXPECT_NEAR(found.sliding, sliding, 1e-12);
    EXPECT_NEAR(found.extraction, extraction, 1e-12);
}

Weights first(double index) { return paper_inference().first(index); }
Weights further(double index, const Weights& previous) { return paper_inference().further(index, previous); }

TEST(FirstFacet, GivesHighToTheNamedCaseAndLowToTheOthers) {
    expect_weights(first(-1), 1, 0, 0);
    expect_weights(first(0), 0, 1, 0);
    expect_weights(first(0.1), 0, 1, 0);
    expect_weights(first(1), 0, 0, 1);
    expect_weights(first(0.99), 0, 0.01 / 0.5858, 1 - 0.01 / 0.5858);
}

TEST(FirstFacet, NeighbouringCasesWeighTheSameAt45Degrees) {
    expect_weights(first(-0.7071), 0.5, 0.5, 0);
    expect_weights(first(0.7071), 0, 0.5, 0.5);
}

TEST(FirstFacet, WeightsSumToOneAndMirror) {
    for (int k = -1000; k <= 1000; ++k) {
        const Weights at = first(k / 1000.0), mirrored = first(-k / 1000.0);
        EXPECT_NEAR(at.penetration + at.sliding + at.extraction, 1, 1e-15);
        EXPECT_NEAR(at.penetration, mirrored.extraction, 1e-15);
    }
}

TEST(FurtherFacet, FollowsTheRuleTable) {
    // Penetration is named (evidence HIGH for P, LOW for S and E), from each previous term.
    expect_weights(further(-1, {0, 0, 0}), 0.5, 0, 0);
    expect_weights(further(-1, {0.5, 0.5, 0.5}), 1, 0, 0);
    expect_weights(further(-1, {1, 1, 1}), 1, 0.5, 0.5);
    // Sliding, and extraction.
    expect_weights(further(0, {0, 0, 1}), 0, 0.5, 0.5);
    expect_weights(further(1, {1, 0.5, 0}), 0.5, 0, 0.5);
}

TEST(FurtherFacet, BetweenTermsIsTheirWeightedAverage) {
    // A quarter is half LOW, half MEDIUM: HIGH evidence gives (½ + 1) / 2, LOW evidence gives 0.
    expect_weights(further(-1, {0.25, 0.25, 0}), 0.75, 0, 0);
    // At 45° the evidence is half HIGH: (0.75 + 0) / 2.
    expect_weights(further(-0.7071, {0.25, 0.25, 0}), 0.375, 0.375, 0);
}

TEST(Inference, AWeightWithoutARuleIsTheDefault) {
    std::string text = with("default: 0\n", "default: 0.25\n");  // of I_P, which comes first
    const std::string asks = "and I_C is", asks_more = "and previous_P is HIGH and I_C is";
    for (std::size_t at = 0; (at = text.find(asks, at)) != std::string::npos; at += asks_more.size()) {
        text.replace(at, asks.size(), asks_more);
    }
    const Inference inference(read_rules(text));
    expect_weights(inference.first(-1), 0.25, 0, 0);
    expect_weights(inference.further(-1, {0.1, 0.9, 0.9}), 0.25, 0, 0);
    EXPECT_GT(inference.further(-1, {0.9, 0.9, 0.9}).penetration, 0.25);
}

TEST(Inference, TheWeightOfARuleMakesItWeaker) {
    const std::string rule = "I_C is sliding then I_P is LOW and I_S is HIGH and I_E is LOW";
    const Inference half(read_rules(with(rule, rule + " with 0.5")));
    // At 45° penetration and sliding hold by ½ each; sliding now counts half: ½ : ¼.
    expect_weights(half.first(-0.7071), 2.0 / 3, 1.0 / 3, 0);
}

RC_GTEST_PROP(Inference, WeightsAreFromZeroToOne, ()) {
    const std::array<std::string, 3> bases = {shipped_rules(), smooth_rules(), crisp_rules()};
    for (const std::string& base : bases) {
        const Inference inference(read_rules(base));
        Weights weights = inference.first(random_number(-1, 1));
        for (int facet = 0; facet < 8; ++facet) {
            for (const double weight : {weights.penetration, weights.sliding, weights.extraction}) {
                RC_ASSERT(weight >= 0);
                RC_ASSERT(weight <= 1);
            }
            weights = inference.further(random_number(-1, 1), weights);
        }
    }
}

RC_GTEST_PROP(Inference, PenetrationIsExtractionOfTheOppositeMotion, ()) {
    const double start = random_number(-1, 1);
    Weights one = first(start), other = first(-start);
    for (int facet = 0; facet < 8; ++facet) {
        RC_ASSERT(std::abs(one.penetration - other.extraction) < 1e-12);
        RC_ASSERT(std::abs(one.sliding - other.sliding) < 1e-12);
        RC_ASSERT(std::abs(one.extraction - other.penetration) < 1e-12);
        const double index = random_number(-1, 1);
        one = further(index, one);
        other = further(-index, other);
    }
}

}  // namespace
}  // namespace trocar::fuzzy
