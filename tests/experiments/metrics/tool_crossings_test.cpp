#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "common/tool/tool_shapes.h"
#include "one_vertex.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;

const Vec3 vertex(0, 0, 5);

/// A block of 4 mm around the vertex if its tip is at the origin.
class ToolCrossings : public testing::Test {
  protected:
    const OneVertex one_{box_tool({-2, -2, 0}, {2, 2, 10})};
    const Pose on_the_right_ = at({5, 0, 0});

    /// The block comes from the right, so that the vertex goes in on its left, and handling puts it there.
    [[nodiscard]] std::size_t put_at(const Vec3& handled) const {
        return one_.crossings(vertex, on_the_right_, at({0, 0, 0}), handled);
    }
};

TEST_F(ToolCrossings, AreVerticesPutOutOppositeToWhereTheyCameIn) {
    EXPECT_EQ(put_at({3, 0, 5}), 1);
    EXPECT_EQ(put_at({3, 1, 6}), 1) << "wherever on that side";
    EXPECT_EQ(put_at({-3, 0, 5}), 0) << "back";
    EXPECT_EQ(put_at({0, 3, 5}), 0) << "at a right angle";
    EXPECT_EQ(put_at({0, 0, -1}), 0) << "at the tip";
    EXPECT_EQ(put_at({1, 0, 5}), 0) << "left inside";
    EXPECT_EQ(put_at(vertex), 0) << "not moved";
    EXPECT_EQ(one_.crossings({0, 1, 5}, on_the_right_, {}, {4, 3, 5}), 1)
        << "over an edge, more to the right";
    EXPECT_EQ(one_.crossings({1, 0, 5}, on_the_right_, {}, {3, 4, 5}), 0) << "over it, less to the right";
}

TEST_F(ToolCrossings, OfVerticesThatComeInOverAnEdge) {
    // Over the edge between the sides of low x and of low y, met more squarely by one of the two.
    const auto crossings = [&](const Vec3& way) {
        const Vec3 edge(-2, -2, 5);
        return one_.crossings(edge + way, at(2 * way), {}, {3, 0, 5});
    };
    EXPECT_EQ(crossings({2, 1, 0}), 1) << "over the side of low x";
    EXPECT_EQ(crossings({1, 2, 0}), 0) << "over the side of low y";
}

TEST_F(ToolCrossings, RememberTheWayInForAsLongAsTheVertexIsInside) {
    // In on the left in the first step and left inside twice, pushed about there; put out in the third.
    const auto put_out_at = [&](const Vec3& handled) {
        Paths paths(one_.state(vertex, on_the_right_));
        paths.move(one_.state(vertex, at({1, 0, 0})));
        EXPECT_EQ(paths.crossings(one_.state(vertex, at({1, 0, 0}))), 0U);
        paths.handle(one_.state({0, 1, 5}, at({1, 0, 0})));
        paths.deform(one_.state({0, 0.5, 5}, at({1, 0, 0})));
        paths.move(one_.state({0, 0.5, 5}, turned_about(vertex, Vec3::UnitZ(), 0.1)));
        paths.handle(one_.state({0.5, 0, 5}, turned_about(vertex, Vec3::UnitZ(), 0.1)));
        paths.move(one_.state({0.5, 0, 5}, at({0, 0, 0})));
        return paths.crossings(one_.state(handled, at({0, 0, 0})));
    };
    EXPECT_EQ(put_out_at({3, 0, 5}), 1);
    EXPECT_EQ(put_out_at({-3, 0, 5}), 0);
    EXPECT_EQ(put_out_at({0, 3, 5}), 0);
}

TEST_F(ToolCrossings, ForgetTheWayInOnceTheVertexIsOutside) {
    // In on the left, out on the left, around the tool, in on the right and out there.
    Paths paths(one_.state(vertex, on_the_right_));
    paths.move(one_.state(vertex, at({0, 0, 0})));
    paths.handle(one_.state({-3, 0, 5}, at({0, 0, 0})));
    paths.deform(one_.state({-3, 9, 5}, at({0, 0, 0})));
    paths.move(one_.state({-3, 9, 5}, at({-9, 0, 0})));
    paths.handle(one_.state({-3, 0, 5}, at({-9, 0, 0})));
    paths.deform(one_.state({-3, 0, 5}, at({-9, 0, 0})));
    paths.move(one_.state({-3, 0, 5}, at({-4, 0, 0})));
    EXPECT_EQ(paths.crossings(one_.state({-1, 0, 5}, at({-4, 0, 0}))), 0) << "out on the right";
    EXPECT_EQ(paths.crossings(one_.state({-7, 0, 5}, at({-4, 0, 0}))), 1) << "out on the left";
}

TEST_F(ToolCrossings, AreNotKnownOfVerticesInsideFromTheBeginning) {
    for (const double x : {-3, 3}) {
        Paths paths(one_.state(vertex, {}));
        paths.move(one_.state(vertex, {}));
        EXPECT_EQ(paths.crossings(one_.state({x, 0, 5}, {})), 0);
    }
}

TEST_F(ToolCrossings, AreAlsoVerticesThatHandlingMovesRightThrough) {
    const auto moved = [&](const Vec3& from, const Vec3& to) {
        return Paths(one_.state(from, {})).crossings(one_.state(to, {}));
    };
    EXPECT_EQ(moved({-3, 0, 5}, {3, 0, 5}), 1);
    EXPECT_EQ(moved({0, 3, 5}, {0.5, -3, 5}), 1);
    EXPECT_EQ(moved({-3, 0, 5}, {0, 4, 5}), 0) << "through one side and its neighbour";
    EXPECT_EQ(moved({-3, 0, 5}, {0, 0, 5}), 0) << "in, not out";
    EXPECT_EQ(moved({-3, 2, 5}, {3, 2, 5}), 0) << "along a side";
}

TEST_F(ToolCrossings, MayBeAskedOfAnyAnswer) {
    Paths paths(one_.state(vertex, on_the_right_));
    paths.move(one_.state(vertex, at({0, 0, 0})));
    const Paths& same = paths;
    for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(same.crossings(one_.state({3, 0, 5}, at({0, 0, 0}))), 1);
        EXPECT_EQ(same.crossings(one_.state({-3, 0, 5}, at({0, 0, 0}))), 0);
    }
    Paths copy = paths;
    copy.handle(one_.state({-3, 0, 5}, at({0, 0, 0})));
    EXPECT_EQ(paths.crossings(one_.state({3, 0, 5}, at({0, 0, 0}))), 1);
    EXPECT_EQ(copy.crossings(one_.state({-3, 0, 5}, at({0, 0, 0}))), 0);
}

TEST_F(ToolCrossings, AreJudgedAtH) {
    const std::vector<Vec3> start = one_.positions(vertex);
    Judge judge(one_.state(vertex, on_the_right_),
                {.metrics = choose_metrics("tool_crossings"), .region = {}, .every = 1});
    judge.before(start, at({1, 0, 0}));
    judge.handled(start, 0);
    EXPECT_EQ(value("tool_crossings", Moment::handled, judge.step()), 0);
    judge.deformed(start);
    judge.before(start, at({0, 0, 0}));
    judge.handled(one_.positions({3, 0, 5}), 0);
    EXPECT_EQ(value("tool_crossings", Moment::handled, judge.step()), 1);
}

TEST(ToolCrossingsAt, SidesMoreThan135DegreesApart) {
    // The side where x is high leans by this angle.
    const auto crossings = [](double degrees) {
        Tool straight = box_tool({-2, -2, 0}, {2, 2, 10});
        SurfaceMesh mesh = straight.mesh;
        for (Vec3& p : mesh.positions) {
            if (p.x() > 0) p.x() += std::tan(degrees * std::numbers::pi / 180) * p.z();
        }
        const OneVertex one(make_tool("leaning", mesh));
        return one.crossings({0, 0, 5}, at({5, 0, 0}), at({0, 0, 0}), {13, 0, 5});
    };
    EXPECT_EQ(crossings(0), 1);
    EXPECT_EQ(crossings(44), 1);
    EXPECT_EQ(crossings(44.99), 1);
    EXPECT_EQ(crossings(45.01), 0);
    EXPECT_EQ(crossings(46), 0);
}

TEST(ToolCrossingsAt, TheLastOfTwoJaws) {
    // From outside in through the outer face of one jaw, over the gap and out through the other.
    const OneVertex one(make_grasper());
    const Vec3 before(0, -30, 4), after(0, 30, 4);
    EXPECT_EQ(Paths(one.state(before, {})).crossings(one.state(after, {})), 1);
    EXPECT_EQ(Paths(one.state(before, {})).crossings(one.state({0, 0, 4}, {})), 1) << "into the gap";
    EXPECT_EQ(Paths(one.state({0, 0, 4}, {})).crossings(one.state({9, 0, 4}, {})), 0) << "beside them";
    const Vec3 in_the_other(0, 5.5, 4);
    ASSERT_TRUE(one.tool().contains(in_the_other));
    EXPECT_EQ(Paths(one.state(before, {})).crossings(one.state(in_the_other, {})), 0) << "not put out";
}

TEST(ToolCrossingsAt, TheJawThatTheVertexCameIntoLast) {
    // From beside it into one jaw, from there straight into the other, and out on its outer side.
    const OneVertex one(make_grasper());
    Paths paths(one.state({9, -5.5, 4}, {}));
    paths.deform(one.state({0, -5.5, 4}, {}));
    EXPECT_EQ(paths.crossings(one.state({0, -30, 4}, {})), 0);
    paths.deform(one.state({0, 5.5, 4}, {}));
    EXPECT_EQ(paths.crossings(one.state({0, 30, 4}, {})), 1);
    EXPECT_EQ(paths.crossings(one.state({0, 0, 4}, {})), 0);
}

TEST(ToolCrossingsAt, AreTheSameForAMovedScene) {
    const OneVertex one(make_prism(7));
    std::size_t crossed = 0;
    EXPECT_TRUE(rc::check([&] {
        const auto around = [] {
            return Vec3(random_number(-6, 6), random_number(-6, 6), random_number(5, 9));
        };
        const Vec3 here = around(), there = around();
        const Pose from = at(random_number(4, 9) * random_direction()), to = at(random_direction());
        const std::size_t crossings = one.crossings(here, from, to, there);
        crossed += crossings;
        const Pose frame = turned_about({3, 4, 5}, random_direction(), random_number(-3, 3));
        const auto moved = [&](const Pose& pose) {
            return Pose{.rotation = frame.rotation * pose.rotation,
                        .position = frame.to_world(pose.position)};
        };
        RC_ASSERT(crossings ==
                  one.crossings(frame.to_world(here), moved(from), moved(to), frame.to_world(there)));
        // What handling moves right through it moves right through on the way back, too.
        if (one.tool().contains(here) || one.tool().contains(there)) return;
        RC_ASSERT(one.crossings(here, {}, {}, there) == one.crossings(there, {}, {}, here));
    }));
    EXPECT_GT(crossed, 5U);
}

}  // namespace
}  // namespace trocar
