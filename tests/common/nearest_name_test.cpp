#include "common/nearest_name.h"

#include <vector>

#include <gtest/gtest.h>

namespace trocar {
namespace {

const std::vector<std::string> shapes = {"sheet", "sphere"};

TEST(NearestName, IsTheOneWithTheFewestChanges) {
    EXPECT_EQ(nearest_name("shpere", shapes), "sphere");
    EXPECT_EQ(nearest_name("shet", shapes), "sheet");
    EXPECT_EQ(nearest_name("sphere", shapes), "sphere");
    EXPECT_EQ(nearest_name("spr", shapes), "sphere") << "half of the letters";
}

TEST(NearestName, IsEmptyWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("liver", shapes), "");
    EXPECT_EQ(nearest_name("", shapes), "");
    EXPECT_EQ(nearest_name("sphere", {}), "");
}

TEST(UnknownName, SaysWhatWasMeantAndWhatThereIs) {
    EXPECT_EQ(unknown_name("organ", "shpere", shapes),
              "unknown organ \"shpere\"; did you mean \"sphere\"? Known: sheet, sphere");
    EXPECT_EQ(unknown_name("organ", "liver", shapes), "unknown organ \"liver\". Known: sheet, sphere");
}

}  // namespace
}  // namespace trocar
