#include "experiments/sweep/shard.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "experiments/input_error.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

/// Cases that are told apart by their ids only; `scenes` says of each which scene it has.
std::vector<CaseInputs> cases_of(const std::vector<int>& scenes) {
    static const SweepFolder folder;
    static const CaseInputs any = list_cases(folder.read(small_sweep)).front();
    std::vector<CaseInputs> cases(scenes.size(), any);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        cases[i].case_id = std::to_string(i);
        cases[i].scene_id = std::to_string(scenes[i]);
    }
    return cases;
}

RC_GTEST_PROP(Shard, EveryCaseIsInOneShardAndEverySceneToo, ()) {
    const auto scenes = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 9)));
    const std::set<int> distinct(scenes.begin(), scenes.end());
    const auto count = *rc::gen::inRange<std::size_t>(1, distinct.size() + 1);
    std::map<std::string, std::size_t> shard_of_scene;
    std::set<std::string> ids;
    std::size_t most = 0, least = scenes.size(), largest_scene = 0;
    for (const int scene : distinct)
        largest_scene = std::max<std::size_t>(largest_scene, std::ranges::count(scenes, scene));
    for (std::size_t number = 1; number <= count; ++number) {
        const auto cases = in_shard(cases_of(scenes), {.number = number, .count = count});
        for (const CaseInputs& one : cases) {
            RC_ASSERT(ids.insert(one.case_id).second);
            RC_ASSERT(shard_of_scene.try_emplace(one.scene_id, number).first->second == number);
        }
        most = std::max(most, cases.size());
        least = std::min(least, cases.size());
    }
    RC_ASSERT(ids.size() == scenes.size());
    RC_ASSERT(most - least <= largest_scene);
}

TEST(Shard, TextsAreReadOrRefused) {
    const Shard shard = parse_shard("2/3");
    EXPECT_EQ(shard.number, 2U);
    EXPECT_EQ(shard.count, 3U);
    for (const auto* text : {"", "/", "1", "0/1", "2/1", "1/0", "-1/2", "1/2 ", "1/2/3", "one/two"})
        EXPECT_THROW(parse_shard(text), InputError) << text;
}

TEST(Shard, MoreShardsThanScenesAreRefused) {
    EXPECT_THROW(in_shard(cases_of({1, 2, 2}), {.number = 3, .count = 3}), InputError);
}

}  // namespace
}  // namespace trocar
