#include "experiments/run/batches.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sweep_folder.h"

namespace trocar {
namespace {

/// Two strategies, two speeds, so many seeds.
std::vector<CaseInputs> cases(int seeds) {
    const SweepFolder folder;
    return list_cases(
        folder.read("name = \"batches\"\nstrategies = [\"nearest-face\", \"cylinder-axis\"]\norgans = "
                    "[\"sphere@10mm\"]\ntools = [\"prism-6\"]\nscenes = [\"penetration\"]\nspeeds = [100, "
                    "400]\nseeds = " +
                    std::to_string(seeds) + "\n"));
}

std::vector<std::string> scenes_of(const std::vector<CaseInputs>& ordered) {
    std::vector<std::string> scenes;
    for (const CaseInputs& one : ordered) {
        if (scenes.empty() || scenes.back() != one.scene_id) scenes.push_back(one.scene_id);
    }
    return scenes;
}

TEST(ByScene, KeepsCasesOfASceneTogetherInTheOrderOfTheFirst) {
    const std::vector<CaseInputs> all = cases(3), ordered = by_scene(all);
    const std::vector<std::string> scenes = scenes_of(ordered);
    EXPECT_EQ(scenes.size(), 6U) << "two speeds, three seeds";
    EXPECT_EQ(scenes.front(), all.front().scene_id);
}

TEST(SpreadOut, KeepsScenesTogetherAndMixesBoth) {
    const std::vector<CaseInputs> ordered = spread_out(cases(20), "seed");
    EXPECT_EQ(scenes_of(ordered).size(), 40U);
    EXPECT_NE(scenes_of(ordered), scenes_of(by_scene(cases(20))));
    int nearest_face_first = 0;
    for (std::size_t k = 0; k < ordered.size(); k += 2) {
        nearest_face_first += ordered[k].strategy.name == "nearest-face" ? 1 : 0;
    }
    EXPECT_GT(nearest_face_first, 8) << "of 40";
    EXPECT_LT(nearest_face_first, 32) << "of 40";
}

TEST(SpreadOut, IsTheSameForTheSameSeed) {
    EXPECT_EQ(scenes_of(spread_out(cases(4), "one")), scenes_of(spread_out(cases(4), "one")));
    EXPECT_NE(scenes_of(spread_out(cases(4), "one")), scenes_of(spread_out(cases(4), "other")));
}

TEST(Batches, HaveEveryCaseOnceAndNeverTwoScenes) {
    for (const unsigned workers : {1U, 2U, 7U, 100U}) {
        const std::vector<CaseInputs> ordered = by_scene(cases(5));
        std::uint64_t next = 0;
        for (const Batch& batch : batches_of(ordered, workers)) {
            EXPECT_EQ(batch.begin, next);
            ASSERT_LT(batch.begin, batch.end);
            for (std::uint64_t k = batch.begin; k < batch.end; ++k) {
                EXPECT_EQ(ordered[k].scene_id, ordered[batch.begin].scene_id);
            }
            next = batch.end;
        }
        EXPECT_EQ(next, ordered.size());
    }
}

TEST(Batches, AreScenesWhereThereAreManyAndPartsWhereThereAreFew) {
    EXPECT_EQ(batches_of(by_scene(cases(20)), 2).size(), 40U);
    EXPECT_EQ(batches_of(by_scene(cases(1)), 2).size(), 4U);
    EXPECT_TRUE(batches_of({}, 2).empty());
}

}  // namespace
}  // namespace trocar
