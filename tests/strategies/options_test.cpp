#include "strategies/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trocar {
namespace {

const std::vector<OptionSpec> specs = {
    {.name = "normals",
     .default_value = std::string("current"),
     .summary = "",
     .choices = {"current", "reference"}},
    {.name = "feedback", .default_value = true, .summary = "", .choices = {}},
    {.name = "reach", .default_value = 2.0, .summary = "mm", .choices = {}, .low = 0, .high = 10},
};

std::string message_of(const Options& given) {
    try {
        (void)resolve_options(specs, given);
    } catch (const OptionError& error) {
        return error.option + ": " + error.what();
    }
    return "no error";
}

TEST(Options, LaysGivenValuesOverTheDefaults) {
    const Options resolved = resolve_options(specs, {{"reach", 7.5}});
    EXPECT_EQ(word(resolved, "normals"), "current");
    EXPECT_TRUE(flag(resolved, "feedback"));
    EXPECT_EQ(number(resolved, "reach"), 7.5);
}

TEST(Options, NamesTheNearestRightNameOfAnUnknownOne) {
    EXPECT_THAT(message_of({{"normal", std::string("current")}}),
                testing::AllOf(testing::StartsWith("normal: "), testing::HasSubstr("\"normals\"")));
}

TEST(Options, NamesTheNearestRightWordOfAnUnknownOne) {
    EXPECT_THAT(message_of({{"normals", std::string("curent")}}),
                testing::HasSubstr("did you mean \"current\""));
}

TEST(Options, SaysWhichKindIsExpected) {
    EXPECT_THAT(message_of({{"feedback", 1.0}}), testing::HasSubstr("must be true or false, not a number"));
    EXPECT_THAT(message_of({{"reach", std::string("far")}}),
                testing::HasSubstr("must be a number, not a text"));
}

TEST(Options, SaysWhichRangeIsAllowed) {
    EXPECT_THAT(message_of({{"reach", 10.5}}), testing::HasSubstr("from 0 to 10, not 10.5"));
    EXPECT_EQ(message_of({{"reach", 10.0}}), "no error");
}

}  // namespace
}  // namespace trocar
