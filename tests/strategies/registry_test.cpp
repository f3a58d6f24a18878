#include "strategies/registry.h"

#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trocar {
namespace {

TEST(Registry, IntroducesEveryStrategyOnceAndInFull) {
    std::set<std::string> names;
    for (const StrategyEntry& entry : all_strategies()) {
        const Description& d = entry.description;
        EXPECT_TRUE(names.insert(d.name).second) << d.name << " twice";
        EXPECT_THAT(d.name, testing::MatchesRegex("[a-z][a-z-]*"));
        EXPECT_FALSE(d.summary.empty()) << d.name;
        EXPECT_FALSE(d.reference.empty()) << d.name;
        for (const OptionSpec& option : d.options) {
            EXPECT_FALSE(option.summary.empty()) << d.name << " " << option.name;
            EXPECT_NO_THROW(resolve_options(d.options, {{option.name, option.default_value}}))
                << d.name << ": the default of " << option.name << " is not allowed";
        }
    }
}

TEST(Registry, NamesTheNearestRightName) {
    try {
        (void)make_strategy("nearest-fase");
        FAIL() << "no error";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("did you mean \"nearest-face\""));
    }
}

}  // namespace
}  // namespace trocar
