// Run under ThreadSanitizer by `make races`.
#include <thread>

#include <gtest/gtest.h>

#include "strategies/registry.h"
#include "tests/strategies/fuzzy/paper_rules.h"
#include "tests/strategies/scenes.h"

namespace trocar::fuzzy {
namespace {

constexpr int threads = 8;

template <typename Work>
void on_eight_threads(const Work& work) {
    std::vector<std::jthread> running;
    for (int k = 0; k < threads; ++k) running.emplace_back(work, k);
}

Weights evaluate_many(const Inference& inference) {
    Weights weights = inference.first(-0.6);
    for (int k = 0; k < 20'000; ++k) weights = inference.further((k % 2001 - 1000) / 1000.0, weights);
    return weights;
}

TEST(EightThreads, ShareOneInference) {
    const Inference inference(read_rules(shipped_rules()));
    const Weights expected = evaluate_many(inference);
    std::array<Weights, threads> found;
    on_eight_threads([&](int k) { found.at(k) = evaluate_many(inference); });
    for (const Weights& weights : found) {
        EXPECT_EQ(weights.penetration, expected.penetration);
        EXPECT_EQ(weights.sliding, expected.sliding);
        EXPECT_EQ(weights.extraction, expected.extraction);
    }
}

TEST(EightThreads, ReadRulesAtOnce) {
    std::array<std::size_t, threads> rules{}, refused{};
    on_eight_threads([&](int k) {
        for (int round = 0; round < 5; ++round) {
            rules.at(k) += read_rules(shipped_rules()).rules.size();
            try {
                (void)read_rules("Engine: nothing");
            } catch (const RuleError&) {
                ++refused.at(k);
            }
        }
    });
    for (int k = 0; k < threads; ++k) {
        EXPECT_EQ(rules.at(k), 150U);
        EXPECT_EQ(refused.at(k), 5U);
    }
}

TEST(EightThreads, HandleTheSameContact) {
    const contract::Scene scene = contract::random_scene(3);
    const Response expected = contract::answer_of("fuzzy-per-vertex", scene);
    ASSERT_FALSE(expected.displacements.empty());
    std::array<Response, threads> found;
    on_eight_threads([&](int k) {
        const auto strategy = make_strategy("fuzzy-per-vertex");
        for (int round = 0; round < 20; ++round) {
            found.at(k).clear();
            scene.with_contact([&](const Contact& contact) { strategy->handle(contact, found.at(k)); });
        }
    });
    for (const Response& response : found) {
        ASSERT_EQ(response.displacements.size(), expected.displacements.size());
        for (std::size_t k = 0; k < expected.displacements.size(); ++k) {
            EXPECT_EQ(response.displacements[k].displacement, expected.displacements[k].displacement);
        }
    }
}

}  // namespace
}  // namespace trocar::fuzzy
