// Which cases of which sweeps `trocar reproduce` runs: each once, and each that a chosen claim is judged on.

#include "experiments/claims/claims_plan.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/input_error.h"
#include "experiments/run/case_options.h"
#include "tests/experiments/sweep_folder.h"

namespace trocar {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// The second sweep's sphere is the first one's, but of 6 seeds where that takes 2 in a quick run.
constexpr std::string_view claims_text = R"(
[sweep."a.toml"]
metrics = ["depth_max"]
quick_seeds = 2
[sweep."b.toml"]
metrics = ["drag"]
quick_seeds = 3
[[claim]]
id = "C1"
sweeps = ["a.toml"]
data = "runs"
[[claim]]
id = "C2"
sweeps = ["b.toml"]
data = "runs"
[[claim]]
id = "C3"
data = "turns"
)";

std::string sweep_text(std::string_view organs, std::string_view seeds) {
    return "name = \"one\"\nstrategies = [\"nearest-face\"]\norgans = " + std::string(organs) +
           "\ntools = [\"prism-12\"]\nscenes = [\"penetration\"]\nspeeds = [400]\nseeds = " +
           std::string(seeds) + "\n[cycle]\nrate = 30\nrelease = \"contact\"\n";
}

class Plan : public testing::Test {
  protected:
    Plan() {
        (void)folder.write("a.toml", sweep_text(R"(["sphere@12mm"])", "4"));
        (void)folder.write("b.toml", sweep_text(R"(["sphere@12mm", "sheet@12mm"])", "6"));
    }

    [[nodiscard]] ClaimsPlan plan(const ClaimsWish& wish, std::string_view text = claims_text) const {
        return plan_claims(folder.write("claims.toml", text), wish);
    }

    SweepFolder folder;
};

/// How many cases of each organ a plan runs.
std::map<std::string, std::size_t> organs_of(const ClaimsPlan& plan) {
    std::map<std::string, std::size_t> count;
    for (const ClaimSweep& one : plan.sweeps) {
        for (const CaseInputs& inputs : one.cases) ++count[inputs.organ.organ->name];
    }
    return count;
}

using Counts = std::map<std::string, std::size_t>;

TEST_F(Plan, ACaseOfTwoSweepsIsRunOnce) {
    const ClaimsPlan all = plan({});
    EXPECT_EQ(organs_of(all), (Counts{{"sphere@12mm", 6}, {"sheet@12mm", 6}}));
    EXPECT_EQ(all.sweeps[0].cases.size(), 4U);
    EXPECT_EQ(all.case_order.size(), 12U);
    EXPECT_EQ(std::set<std::string>(all.case_order.begin(), all.case_order.end()).size(), 12U);
    EXPECT_TRUE(all.needs_turns);

    // The sphere's cases, which are the first sweep's, are measured as the second wants them too.
    EXPECT_EQ(metric_names(all.sweeps[0].metrics), "depth_max,drag");
    EXPECT_EQ(metric_names(all.sweeps[1].metrics), "drag");
}

TEST_F(Plan, AClaimHasAllItsCasesWhoeverElseHasThem) {
    const ClaimsPlan second = plan({.chosen = {"C2"}, .meshes = {}});
    EXPECT_EQ(organs_of(second), (Counts{{"sphere@12mm", 6}, {"sheet@12mm", 6}}));
    EXPECT_EQ(second.case_order.size(), 12U);
    EXPECT_FALSE(second.needs_turns);

    EXPECT_EQ(organs_of(plan({.chosen = {"C1"}, .meshes = {}})), (Counts{{"sphere@12mm", 4}}));
    EXPECT_EQ(organs_of(plan({.chosen = {"C3"}, .meshes = {}})), Counts{});
}

TEST_F(Plan, AQuickRunTakesTheSeedsThatAnyOfItsSweepsWants) {
    EXPECT_EQ(organs_of(plan({.chosen = {}, .is_quick = true, .meshes = {}})),
              (Counts{{"sphere@12mm", 3}, {"sheet@12mm", 3}}));
    EXPECT_EQ(organs_of(plan({.chosen = {"C1"}, .is_quick = true, .meshes = {}})),
              (Counts{{"sphere@12mm", 2}}));
}

TEST_F(Plan, NumbersDoNotDependOnWhatIsAskedFor) {
    std::map<std::string, std::int64_t> numbers;
    for (const ClaimSweep& one : plan({}).sweeps) {
        for (const CaseInputs& inputs : one.cases) numbers[inputs.case_id] = inputs.sweep_number;
    }
    for (const ClaimSweep& one : plan({.chosen = {"C2"}, .is_quick = true, .meshes = {}}).sweeps) {
        for (const CaseInputs& inputs : one.cases) EXPECT_EQ(inputs.sweep_number, numbers.at(inputs.case_id));
    }
}

TEST_F(Plan, MistakesAreNamedWithTheFileThatHasThem) {
    const auto refused = [&](const ClaimsWish& wish, std::string_view from,
                             std::string_view to) -> std::string {
        try {
            (void)plan(wish, replaced(std::string(claims_text), from, to));
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(refused({}, "[sweep.\"b.toml\"]", "[sweep.\"d.toml\"]"),
                HasSubstr("claim C2 is judged on b.toml, but there is no [sweep.\"b.toml\"]"));
    EXPECT_THAT(refused({}, "quick_seeds = 3", "quick_seeds = 0"),
                HasSubstr("claims.toml:7:15: quick_seeds must be"));
    EXPECT_THAT(refused({}, "quick_seeds = 3", "quick = 3"),
                AllOf(HasSubstr("claims.toml:7:1: "), HasSubstr("quick_seeds")));
    EXPECT_THAT(refused({}, "[\"b.toml\"]", "[\"c.toml\"]"),
                AllOf(HasSubstr("c.toml: there is no such file"), HasSubstr("claim C2 names it")));
    EXPECT_THAT(refused({}, "depth_max", "depth_mix"),
                AllOf(HasSubstr("claims.toml:3:11: "), HasSubstr("did you mean \"depth_max\"")));
    EXPECT_THAT(refused({.chosen = {"C9"}, .meshes = {}}, "C3", "C3"), HasSubstr("unknown claim \"C9\""));
}

}  // namespace
}  // namespace trocar
