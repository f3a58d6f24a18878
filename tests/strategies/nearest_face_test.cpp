#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

/// How nearest-face moves a vertex inside an upright square tool (sides 2 √2 mm from the axis) with its tip
/// at the origin.
Vec3 moved_from(const Vec3& inside) {
    const std::vector<Vec3> corners = {inside + Vec3(1, 0, 0), inside + Vec3(0, 1, 0),
                                       inside + Vec3(-1, -1, 0)};
    const Response response =
        contract::answer_of("nearest-face", contract::single_vertex(inside, corners, {0, 0, -1}));
    EXPECT_EQ(response.displacements.size(), 1U);
    return response.displacements.at(0).displacement;
}

TEST(NearestFace, NearTheTipGoesOutThroughTheTip) {
    EXPECT_TRUE(moved_from({0.1, 0.2, 1}).isApprox(Vec3(0, 0, -1.01), 1e-12));
}

TEST(NearestFace, FurtherUpGoesOutThroughTheNearestSide) {
    // The side x + y = 4: the vertex at (1.5, 1.5) is 1 / √2 below it.
    const double along = (std::numbers::sqrt2 / 2 + 0.01) / std::numbers::sqrt2;
    EXPECT_TRUE(moved_from({1.5, 1.5, 7}).isApprox(Vec3(along, along, 0), 1e-12));
}

TEST(NearestFace, ARapidToolPushesNothingAheadOfItsTip) {
    // The paper's Fig. 5b: deep inside, the tip is never the nearest face.
    EXPECT_EQ(moved_from({1.5, 1.5, 7}).z(), 0);
}

}  // namespace
}  // namespace trocar
