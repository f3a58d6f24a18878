#include "experiments/run/shared_scenes.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sweep_folder.h"

namespace trocar {
namespace {

TEST(SharedScenes, CasesThatDifferInTheStrategyOrTheReleaseShareOne) {
    const SweepFolder folder;
    const auto cases = list_cases(folder.read(small_sweep + "[cycle]\nrelease = [\"contact\", \"step\"]\n"));
    ASSERT_EQ(cases.size(), 8U);
    SharedScenes scenes(cases);
    std::vector<std::shared_ptr<const PreparedScene>> found(cases.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < cases.size(); ++k) {
            threads.emplace_back([&, k] { found[k] = scenes.scene_of(cases[k]); });
        }
    }
    for (std::size_t a = 0; a < cases.size(); ++a) {
        for (std::size_t b = 0; b < cases.size(); ++b) {
            EXPECT_EQ(found[a] == found[b], cases[a].seed == cases[b].seed);
        }
    }
}

TEST(SharedScenes, LetGoOfASceneAfterItsLastCase) {
    const SweepFolder folder;
    const auto cases = list_cases(folder.read(replaced(small_sweep, "seeds = 2", "seeds = 1")));
    SharedScenes scenes(cases);
    std::weak_ptr<const PreparedScene> watched = scenes.scene_of(cases[0]);
    EXPECT_FALSE(watched.expired()) << "another case is to come";
    (void)scenes.scene_of(cases[1]);
    EXPECT_TRUE(watched.expired());
}

TEST(SharedScenes, ASceneThatCannotBePreparedFailsEachOfItsCases) {
    const SweepFolder folder;
    const auto cases = list_cases(
        folder.read(replaced(replaced(small_sweep, "penetration", "thin"), "seeds = 2", "seeds = 1")));
    SharedScenes scenes(cases);
    for (const CaseInputs& inputs : cases) EXPECT_THROW(scenes.scene_of(inputs), PlacementError);
}

}  // namespace
}  // namespace trocar
