#include "common/tool/tool_shapes.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/adjacency.h"
#include "common/geometry/predicates.h"

namespace trocar {
namespace {

class Prism : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sides, Prism, testing::Values(3, 4, 6, 12, 64));

TEST_P(Prism, IsAClosedSolidOfTheRightSize) {
    const int sides = GetParam();
    const Tool tool = make_tool_by_formula("prism-" + std::to_string(sides));
    EXPECT_EQ(tool.name, "prism-" + std::to_string(sides));
    EXPECT_TRUE(Adjacency(tool.mesh.positions.size(), tool.mesh.facets).closed());
    const double angle = 2 * M_PI / sides;
    EXPECT_NEAR(signed_volume(tool.mesh), 80 * sides * 16 * std::sin(angle) / 2, 1e-9);
    for (const Vec3& position : tool.mesh.positions) {
        EXPECT_NEAR(std::hypot(position.x(), position.y()), 4, 1e-14);
        EXPECT_TRUE(position.z() == 0 || position.z() == 80);
    }
}

TEST_P(Prism, HasExactlyFlatSidesAndEnds) {
    const Tool tool = make_prism(GetParam());
    const auto is_flat = [&](const Facet& f, Index vertex) {
        const std::vector<Vec3>& p = tool.mesh.positions;
        return orientation_sign(p[f[0]], p[f[1]], p[f[2]], p[vertex]) == 0;
    };
    const Index sides = GetParam();
    for (Index side = 0; side < sides; ++side) {
        const Index lower = 2 * side, upper = lower + 1;  // the two facets of this side
        EXPECT_TRUE(is_flat(tool.mesh.facets[lower], tool.mesh.facets[upper][2]));
    }
    EXPECT_EQ(tool.solid.face_count(), static_cast<std::size_t>(sides) + 2);
}

TEST(Prism, OfOtherSizesHasThemInItsName) {
    EXPECT_EQ(make_prism(6, 5, 80).name, "prism-6 r5 l80");
    EXPECT_EQ(make_prism(6, 4, 40.5).name, "prism-6 r4 l40.5");
    EXPECT_EQ(make_prism(6, 4, 80).name, "prism-6");
}

TEST(Prism, RefusesWhatIsNoPrism) {
    EXPECT_THROW(make_prism(2), std::invalid_argument);
    EXPECT_THROW(make_prism(65), std::invalid_argument);
    EXPECT_THROW(make_prism(6, 0), std::invalid_argument);
    EXPECT_THROW(make_prism(6, 4, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(ToolByFormula, SaysWhatWasExpected) {
    const auto message_of = [](const std::string& formula) -> std::string {
        try {
            make_tool_by_formula(formula);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    EXPECT_EQ(message_of("prsm-12"), "unknown tool \"prsm-12\"; did you mean \"prism-N\"? Known: prism-N");
    for (const std::string wrong : {"prism-", "prism-2", "prism-65", "prism-6x", "prism-6.5", "prism--6"}) {
        EXPECT_EQ(
            message_of(wrong),
            "tool \"" + wrong + "\": expected prism-N, N a whole number from 3 to 64, such as prism-12");
    }
}

}  // namespace
}  // namespace trocar
