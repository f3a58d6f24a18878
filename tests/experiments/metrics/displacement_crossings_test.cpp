#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/tool/tool_shapes.h"
#include "judged_steps.h"

namespace trocar {
namespace {

/// A facet of which the edge from a = (−0.5, 0, 0) to b = (0.5, 0, 0) lies in the tool, the third corner far
/// away.
class OneEdge {
  public:
    static constexpr Index a = 0, b = 1;

    /// A step in which a and b are put somewhere.
    [[nodiscard]] Judged put(const Vec3& a_to, const Vec3& b_to) const {
        return steps.step(tip_at(-20), steps.rest(), {a_to, b_to, steps.rest()[2]}, steps.rest());
    }

    const JudgedSteps steps{
        make_organ("facet", {.positions = {{-0.5, 0, 0}, {0.5, 0, 0}, {0, 100, 0}}, .facets = {{0, 1, 2}}}),
        make_prism(4, 10, 40)};
};

const OneEdge edge;

double crossings(const Judged& step) { return value("displacement_crossings", Moment::handled, step); }

// A goes low and far, b steeply over its path; b ends to the right of a, so the edge is not turned around.
const Vec3 a_far(2, 1, 0), b_steep(2.2, 3, 0);

TEST(DisplacementCrossings, CountsSegmentsThatCross) {
    EXPECT_EQ(crossings(edge.put(a_far, b_steep)), 1);
    EXPECT_EQ(crossings(edge.put(edge.steps.rest()[0], edge.steps.rest()[1])), 0);
}

TEST(DisplacementCrossings, CountsSegmentsWithinATenthOfTheEdge) {
    // The lines' distance is h / sqrt(7.25 h² + 33.64), in edge lengths: 0.09 at 0.538, 0.11 at 0.668.
    EXPECT_EQ(crossings(edge.put(a_far, b_steep + Vec3(0, 0, 0.538))), 1);
    EXPECT_EQ(crossings(edge.put(a_far, b_steep + Vec3(0, 0, 0.668))), 0);
}

TEST(DisplacementCrossings, DoesNotCountSegmentsThatShareAnEnd) {
    EXPECT_EQ(crossings(edge.put(a_far, a_far)), 0);
    EXPECT_EQ(crossings(edge.put({0.3, 0.7, 0.1}, {0.3, 0.7, 0.1})), 0);
}

TEST(DisplacementCrossings, DoesNotCountSegmentsThatMeetBeyondAnEnd) {
    // B stops before a's path, then a before b's.
    EXPECT_EQ(crossings(edge.put({0.2, 0.7, 0}, {0.25, 0.25, 0})), 0);
    EXPECT_EQ(crossings(edge.put({0.4, 0.36, 0}, b_steep)), 0);
}

/// Both go up the slope, b more steeply by `degrees`; their paths cross.
Judged climb(double degrees) {
    const double slow = 4 * std::numbers::pi / 180, steep = (4 + degrees) * std::numbers::pi / 180;
    return edge.put({-0.5 + 2.5 * std::cos(slow), 2.5 * std::sin(slow), 0},
                    {0.5 + 2 * std::cos(steep), 2 * std::sin(steep), 0});
}

TEST(DisplacementCrossings, DoesNotCountSegmentsSideBySide) {
    EXPECT_EQ(crossings(climb(6)), 1);
    EXPECT_EQ(crossings(climb(4)), 0);
}

TEST(DisplacementCrossings, CountsAnEdgeThatIsTurnedAround) {
    // Parallel segments, so nothing but the turn counts.
    EXPECT_EQ(crossings(edge.put({0.5, 0, 2}, {-0.5, 0, -2})), 1);
    EXPECT_EQ(crossings(edge.put({-0.5, 0, 2}, {0.5, 0, -2})), 0);
    // A right angle is not turned around.
    EXPECT_EQ(crossings(edge.put({-0.5, 0, 0}, {-0.5, 0, -1})), 0);
}

TEST(DisplacementCrossings, AsksForBothEndsToBeCollided) {
    // The edge lies at the tool's tip, then one end of it below: a, put beyond b, turns it around.
    for (const bool both : {true, false}) {
        const std::vector<Vec3> before{
            {-0.5, 0, -19.95}, {0.5, 0, both ? -19.95 : -20.05}, edge.steps.rest()[2]};
        std::vector<Vec3> handled = before;
        handled[OneEdge::a].x() = 5;
        EXPECT_EQ(crossings(edge.steps.step(tip_at(-20), before, handled, handled)), both ? 1 : 0);
        std::vector<Vec3> other_way = before;
        other_way[OneEdge::b].x() = -5;
        EXPECT_EQ(crossings(edge.steps.step(tip_at(-20), before, other_way, other_way)), both ? 1 : 0);
    }
}

}  // namespace
}  // namespace trocar
