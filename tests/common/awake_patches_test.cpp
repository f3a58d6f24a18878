#include "common/deformation/awake_patches.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

TEST(AwakePatches, ListTheirPatchesAndSpringsInOrderAfterAnyChange) {
    SpringNetwork network = surface_springs(make_organ_by_formula("sphere@3mm"), {});
    const SpringLayout layout = lay_out(network, 0.01);
    ASSERT_GT(layout.patches(), 20U);
    AwakePatches awake(layout);
    std::set<std::uint32_t> expected;
    std::mt19937 generator(8);  // NOLINT(bugprone-random-generator-seed): the same in every run
    const auto some = [&] {
        std::vector<std::uint32_t> patches;
        for (std::uint32_t k = 0; k < layout.patches(); ++k) {
            if (generator() % 4 == 0) patches.push_back(k);
        }
        std::ranges::shuffle(patches, generator);
        return patches;
    };
    for (int round = 0; round < 50; ++round) {
        const std::vector<std::uint32_t> to_wake = some();
        std::set<std::uint32_t> new_ones;
        for (const std::uint32_t patch : to_wake) {
            if (expected.insert(patch).second) new_ones.insert(patch);
        }
        const auto woken = awake.wake(to_wake);
        EXPECT_TRUE(std::ranges::equal(woken, new_ones));
        std::vector<std::uint32_t> to_sleep;
        for (const std::uint32_t patch : some()) {
            if (expected.erase(patch) > 0) to_sleep.push_back(patch);
        }
        awake.let_sleep(to_sleep);

        EXPECT_TRUE(std::ranges::equal(awake.patches(), expected));
        if (round % 3 == 0) awake.settle();
        std::set<std::pair<std::uint32_t, std::uint32_t>> springs;
        for (const auto& spring : layout.springs) {
            if (expected.contains(layout.patch_of[spring.a]) ||
                expected.contains(layout.patch_of[spring.b])) {
                springs.emplace(spring.a, spring.b);
            }
        }
        std::uint32_t level = 0;
        awake.for_each_level([&](std::span<const SpringLayout::Spring> of_level) {
            EXPECT_LE(level, of_level.front().level);
            level = of_level.front().level;
            for (const auto& spring : of_level) {
                EXPECT_EQ(spring.level, level);
                EXPECT_EQ(springs.erase({spring.a, spring.b}), 1U) << "each once";
            }
        });
        EXPECT_TRUE(springs.empty()) << "all of them";
        for (std::uint32_t k = 0; k < layout.patches(); ++k) {
            EXPECT_EQ(awake.awake(k), expected.contains(k));
        }
    }
}

}  // namespace
}  // namespace trocar
