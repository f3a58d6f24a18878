// Metrics of the edges around collided vertices: spread, edge_ratio.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "square.h"

namespace trocar {
namespace {

const Square square;

TEST(Spread, IsZeroWhereAllMoveAlike) {
    std::vector<Vec3> moved = square.steps().rest();
    for (Vec3& position : moved) position += Vec3(1, 2, 3);
    EXPECT_NEAR(value("spread", Moment::handled, square.handled(moved)), 0, 1e-15);
}

TEST(Spread, IsTheMeanDifferenceOverTheEdgesLength) {
    // One vertex moves by 3: it has edges of lengths 1, 1 and, across, √2; the other two do not change.
    const Vec3 away(-0.5, 0, 3);
    EXPECT_NEAR(value("spread", Moment::handled, square.put(away, square.steps().rest()[1])),
                (3 + 3 + 3 / std::numbers::sqrt2) / 5, 1e-14);
}

TEST(Spread, AsksForBothEndsToBeCollided) {
    const JudgedSteps& steps = square.steps();
    std::vector<Vec3> before = steps.rest(), handled;
    before[Square::b].z() = -21;  // below the tip: edges 0–1 and 1–2 have one collided end
    handled = before;
    handled[0].x() += 3;
    // Left are 0–2 (√2), 0–3 and 2–3 (1 each).
    EXPECT_NEAR(value("spread", Moment::handled, steps.step(tip_at(-20), before, handled, handled)),
                (3 / std::numbers::sqrt2 + 3) / 3, 1e-14);
    for (const Index vertex : {0, 2}) before[vertex].z() = -21;
    EXPECT_EQ(why_missing("spread", Moment::handled, steps.step(tip_at(-20), before, before, before)),
              Missing::no_edge_collided);
}

TEST(EdgeRatio, IsLengthOverLengthAtRest) {
    // Edge 0–1 is halved, 0–2 and 0–3 change with it.
    const Judged step = square.put({0, 0, 0}, {0.5, 0, 0});
    const double to_2 = std::sqrt(1.25) / std::numbers::sqrt2, to_3 = std::sqrt(1.25);
    EXPECT_NEAR(value("edge_ratio_min", Moment::handled, step), 0.5, 1e-15);
    EXPECT_NEAR(value("edge_ratio_mean", Moment::handled, step), (0.5 + to_2 + to_3 + 1 + 1) / 5, 1e-14);
}

TEST(EdgeRatio, IsTakenAgainAfterDeformation) {
    const JudgedSteps& steps = square.steps();
    std::vector<Vec3> twice = steps.rest();
    for (Vec3& position : twice) position *= 2;
    const Judged step = steps.step(tip_at(-20), steps.rest(), steps.rest(), twice);
    EXPECT_EQ(value("edge_ratio_mean", Moment::handled, step), 1);
    EXPECT_EQ(value("edge_ratio_mean", Moment::deformed, step), 2);
    EXPECT_EQ(value("edge_ratio_min", Moment::deformed, step), 2);
}

TEST(EdgeRatio, AsksForOneCollidedEnd) {
    const JudgedSteps& steps = square.steps();
    std::vector<Vec3> before = steps.rest();
    for (const Index vertex : {1, 2, 3}) before[vertex].z() = -21;
    std::vector<Vec3> handled = before;
    handled[0] = before[1];
    // Only the three edges of vertex 0 count: one has collapsed.
    const Judged step = steps.step(tip_at(-20), before, handled, handled);
    EXPECT_EQ(value("edge_ratio_min", Moment::handled, step), 0);
    EXPECT_NEAR(value("edge_ratio_mean", Moment::handled, step),
                (0 + std::numbers::sqrt2 / 2 + std::numbers::sqrt2) / 3, 1e-14);
    before[0].z() = -21;
    const Judged none = steps.step(tip_at(-20), before, before, before);
    EXPECT_EQ(why_missing("edge_ratio_mean", Moment::handled, none), Missing::no_edge_collided);
    EXPECT_EQ(why_missing("edge_ratio_min", Moment::deformed, none), Missing::no_edge_collided);
}

}  // namespace
}  // namespace trocar
