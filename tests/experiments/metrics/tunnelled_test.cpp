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
using testing_support::random_point;

constexpr double degree = std::numbers::pi / 180;

/// A blade of 0.2 mm, 10 mm wide along y.
Tool blade() { return box_tool({-0.1, -5, 0}, {0.1, 5, 80}); }

TEST(Tunnelled, IsAVertexThatTheToolWentThroughBetweenTwoLooks) {
    const OneVertex one(blade());
    EXPECT_TRUE(one.tunnels({3, 1, 20}, at({0, 0, 0}), at({6, 0, 0})));
    EXPECT_FALSE(one.tunnels({3, 1, 20}, at({0, 0, 0}), at({2.89, 0, 0}))) << "not there yet";
    EXPECT_FALSE(one.tunnels({3, 1, 20}, at({0, 0, 0}), at({3.05, 0, 0}))) << "inside now: detected";
    EXPECT_FALSE(one.tunnels({0.05, 1, 20}, at({0, 0, 0}), at({6, 0, 0}))) << "was left inside";
    EXPECT_FALSE(one.tunnels({3, 1, 20}, at({0, 0, 0}), at({0, 0, 0}))) << "nothing moves";
}

TEST(Tunnelled, IsAVertexThatDeformationTakesThroughTheTool) {
    const OneVertex one(blade());
    EXPECT_TRUE(one.tunnels({-2, 1, 20}, {2, 1, 20}, {}, {}));
    EXPECT_TRUE(one.tunnels({-2, 1, 20}, {2, 1, 20}, {}, at({1, 0, 0})));
    EXPECT_FALSE(one.tunnels({-2, 1, 20}, {0.05, 1, 20}, {}, {})) << "ends inside";
    EXPECT_TRUE(one.tunnels({-2, 1, 20}, {0.05, 1, 20}, {}, at({1, 0, 0})))
        << "went in by deformation, out by the tool's motion";
    EXPECT_FALSE(one.tunnels({0.05, 1, 20}, {2, 1, 20}, {}, at({5, 0, 0}))) << "was left inside";
    EXPECT_FALSE(one.tunnels({-2, 1, 20}, {-1, 1, 20}, {}, at({-0.5, 0, 0})));
}

TEST(Tunnelled, IsAVertexThatATurnSweeps) {
    const OneVertex one(blade());
    // About its own axis: the vertex is beside the blade, 4 mm from the axis, before and after.
    const Vec3 beside(0.5, 4, 20);
    const Pose turned = turned_about(Vec3::Zero(), Vec3::UnitZ(), -20 * degree);
    EXPECT_TRUE(one.tunnels(beside, {}, turned));
    EXPECT_FALSE(one.tunnels(beside, {}, turned_about(Vec3::Zero(), Vec3::UnitZ(), 20 * degree)));
    EXPECT_FALSE(one.tunnels({0.5, 5.2, 20}, {}, turned)) << "beyond the blade's edge";
    // About a distant pivot, as in an incision.
    const Vec3 pivot(0, 0, 150);
    EXPECT_TRUE(one.tunnels({1, 0, 20}, {}, turned_about(pivot, Vec3::UnitY(), -1 * degree)));
    EXPECT_FALSE(one.tunnels({1, 0, 20}, {}, turned_about(pivot, Vec3::UnitY(), 1 * degree)));
    EXPECT_FALSE(one.tunnels({3, 0, 20}, {}, turned_about(pivot, Vec3::UnitY(), -1 * degree)));
}

TEST(Tunnelled, FollowsTheArcNotItsChord) {
    // Seen from the tool the vertex goes a quarter of a circle around the axis; the block is across the arc
    // and not across its chord, or the other way round.
    const Vec3 vertex(10, 0, 5);
    const Pose turned = turned_about(Vec3::Zero(), Vec3::UnitZ(), -90 * degree);
    const double middle = 10 / std::numbers::sqrt2;
    const Vec3 half(0.5, 0.5, 10);
    const auto block_at = [&](double x) {
        return OneVertex(box_tool(Vec3(x, x, 5) - half, Vec3(x, x, 5) + half));
    };
    EXPECT_TRUE(block_at(middle).tunnels(vertex, {}, turned));
    EXPECT_FALSE(block_at(5).tunnels(vertex, {}, turned));
    EXPECT_FALSE(
        block_at(middle).tunnels(vertex, {}, turned_about(Vec3::Zero(), Vec3::UnitZ(), 90 * degree)));
}

TEST(Tunnelled, IsSeenWhereTheArcLeavesTheBoxOfItsEnds) {
    const OneVertex one(box_tool({9.5, -0.5, 0}, {10.5, 0.5, 10}));
    const Pose back = turned_about(Vec3::Zero(), Vec3::UnitZ(), 45 * degree);
    const Pose on = turned_about(Vec3::Zero(), Vec3::UnitZ(), -45 * degree);
    EXPECT_TRUE(one.tunnels({10, 0, 5}, back, on));
    EXPECT_FALSE(one.tunnels({11, 0, 5}, back, on));
}

TEST(Tunnelled, GoesInByTheArcToWithinItsError) {
    const Vec3 vertex(10, 0, 5);
    const Pose turned = turned_about(Vec3::Zero(), Vec3::UnitZ(), -90 * degree);
    const auto reaches = [&](double radius) {  // a block whose edge along z is this far from the axis
        const OneVertex one(
            box_tool({radius / std::numbers::sqrt2, radius / std::numbers::sqrt2, -10}, {20, 20, 10}));
        return one.tunnels(vertex, {}, turned);
    };
    EXPECT_TRUE(reaches(10 - 1.1 * arc_error));
    EXPECT_FALSE(reaches(10 + 1e-6));
}

TEST(Tunnelled, IsNotAVertexThatPassesBy) {
    const OneVertex one(blade());
    for (const double apart : {1e-6, 0.0}) {
        const double x = 0.1 + apart, y = 5 + apart, z = -apart;
        EXPECT_FALSE(one.tunnels({x, -9, 20}, {x, 9, 20}, {}, {})) << "along a face";
        EXPECT_FALSE(one.tunnels({x, -9, 11}, {x, 9, 33}, {}, {})) << "along a face, aslant";
        EXPECT_FALSE(one.tunnels({x, 1, -7}, {x, 1, 99}, {}, {})) << "along a face";
        EXPECT_FALSE(one.tunnels({x, y, -7}, {x, y, 99}, {}, {})) << "along an edge";
        EXPECT_FALSE(one.tunnels({x - 1, y + 1, 20}, {x + 1, y - 1, 20}, {}, {})) << "touching an edge";
        EXPECT_FALSE(one.tunnels({x - 1, y + 1, z}, {x + 1, y - 1, z}, {}, {})) << "touching a corner";
        EXPECT_FALSE(one.tunnels({0, 0, -5}, {0, 0, z}, {}, at({0, 0, 5}))) << "touching the tip from below";
        EXPECT_FALSE(one.tunnels({5, 0, 20}, {x, 0, 20}, {}, at({-5, 0, 0}))) << "touching a face and back";
    }
    const double within = 1e-6;
    EXPECT_TRUE(one.tunnels({0.1 - within, -9, 20}, {0.1 - within, 9, 20}, {}, {}));
    EXPECT_TRUE(one.tunnels({-0.9 - within, 6, 20}, {1.1 - within, 4, 20}, {}, {})) << "through an edge";
}

TEST(Tunnelled, IsAVertexThatGoesThroughEdgesAndCorners) {
    const OneVertex one(box_tool({-2, -2, 0}, {2, 2, 8}));
    EXPECT_TRUE(one.tunnels({-4, -4, 3}, {4, 4, 3}, {}, {})) << "in at an edge, out at another";
    EXPECT_TRUE(one.tunnels({-4, -4, -4}, {6, 6, 16}, {}, {})) << "corner to corner";
    EXPECT_TRUE(one.tunnels({-4, 0, 4}, {4, 0, 4}, {}, {})) << "through the edges between a face's facets";
    EXPECT_TRUE(one.tunnels({-2, 0, 4}, {2, 0, 4}, {}, {})) << "from face to face";
}

TEST(Tunnelled, SeesTheGapBetweenTheJaws) {
    const OneVertex one(make_grasper());
    EXPECT_FALSE(one.tunnels({-5, 0, 4}, {5, 0, 4}, {}, {})) << "between them";
    EXPECT_TRUE(one.tunnels({0, 0, 4}, {0, 30, 4}, {}, {})) << "out through one of them";
    EXPECT_TRUE(one.tunnels({0, -30, 4}, {0, 30, 4}, {}, {})) << "through both";
}

TEST(Tunnelled, IsJudgedInEveryStep) {
    const JudgedSteps sheet(
        make_organ("facet", {.positions = {{3, 1, 20}, {500, 1, 0}, {500, 0, 1}}, .facets = {{0, 1, 2}}}),
        blade());
    Judge judge(sheet.state(sheet.rest(), at({0, 0, 0})),
                {.metrics = choose_metrics("tunnelled,tool_crossings"), .region = {}, .every = 1});
    const auto step = [&](const Vec3& tip) {
        judge.before(sheet.rest(), at(tip));
        judge.handled(sheet.rest(), 0);
        judge.deformed(sheet.rest());
        return judge.values().at(0).value;
    };
    EXPECT_EQ(step({1, 0, 0}), 0);
    EXPECT_EQ(step({6, 0, 0}), 1);
    EXPECT_EQ(step({7, 0, 0}), 0) << "not once more";
    EXPECT_EQ(step({-7, 0, 0}), 1) << "on the way back";
}

/// A vertex and a tool, both of which move by screws and straight lines; the tool is sampled densely.
struct RandomWay {
    Vec3 handled, deformed;
    Pose from, pivot;
    Vec3 axis;
    double angle;

    [[nodiscard]] Pose tool_at(double part) const {
        return turned_about(pivot.position, axis, part * angle, from);
    }
    /// How deep inside (positive) or how far outside it comes at most, mm, at the points looked at; these are
    /// no further apart than `spacing`.
    struct Seen {
        double deepest, spacing;
    };
    [[nodiscard]] Seen look(const JudgedTool& tool) const {
        constexpr int looks = 300;
        Seen seen{.deepest = -1e9, .spacing = 0};
        Vec3 last = judged_position(from, handled);
        const auto look_at = [&](const Vec3& point) {
            const double distance = tool.surface().distance(point);
            seen.deepest = std::max(seen.deepest, tool.contains(point) ? distance : -distance);
            seen.spacing = std::max(seen.spacing, (point - last).norm());
            last = point;
        };
        for (int k = 0; k <= looks; ++k) {
            const double part = static_cast<double>(k) / looks;
            look_at(judged_position(from, handled + part * (deformed - handled)));
        }
        for (int k = 1; k <= looks; ++k) {
            look_at(judged_position(tool_at(static_cast<double>(k) / looks), deformed));
        }
        return seen;
    }
};

RandomWay random_way(const JudgedTool& tool) {
    Box near = tool.box();
    near.high.z() = std::min(near.high.z(), near.low.z() + 12);
    const auto somewhere = [&] { return random_point(near.grown(2)); };
    RandomWay way{.handled = somewhere(),
                  .deformed = somewhere(),
                  .from = {},
                  .pivot = at(20 * random_direction() * random_number(0, 3)),
                  .axis = random_direction(),
                  .angle = random_number(-0.4, 0.4)};
    if (*rc::gen::arbitrary<bool>()) way.handled = way.deformed;
    const Pose frame = turned_about(somewhere(), random_direction(), random_number(-3, 3));
    way.from = frame;
    way.handled = frame.to_world(way.handled);
    way.deformed = frame.to_world(way.deformed);
    return way;
}

TEST(Tunnelled, AgreesWithDenseSamples) {
    const OneVertex prism(make_prism(5)), thin(blade()), grasper(make_grasper());
    int through = 0, past = 0;
    EXPECT_TRUE(rc::check([&] {
        const OneVertex& one = **rc::gen::element(&prism, &thin, &grasper);
        const RandomWay way = random_way(one.tool());
        const Pose to = way.tool_at(1);
        RC_PRE(!one.tool().contains(judged_position(way.from, way.handled)));
        const bool ends_inside = one.tool().contains(judged_position(to, way.deformed));
        const bool tunnels = one.tunnels(way.handled, way.deformed, way.from, to);
        if (ends_inside) {
            RC_ASSERT(!tunnels);
            return;
        }
        const RandomWay::Seen seen = way.look(one.tool());
        if (seen.deepest > 2 * arc_error) {
            RC_ASSERT(tunnels);
            ++through;
        }
        if (seen.deepest < -2 * arc_error - seen.spacing) {
            RC_ASSERT(!tunnels);
            ++past;
        }
    }));
    EXPECT_GT(through, 10);
    EXPECT_GT(past, 5);
}

TEST(Tunnelled, IsTheSameForAMovedSceneAMirroredOneAndTheWayBack) {
    const Tool tool = make_grasper();
    SurfaceMesh mirrored_mesh = tool.mesh;
    for (Vec3& p : mirrored_mesh.positions) p.x() = -p.x();
    for (Facet& facet : mirrored_mesh.facets) std::swap(facet[1], facet[2]);
    const OneVertex one(tool), mirrored(make_tool("mirrored", mirrored_mesh));
    const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
    int through = 0;
    EXPECT_TRUE(rc::check([&] {
        const RandomWay way = random_way(one.tool());
        const Pose to = way.tool_at(1);
        RC_PRE(std::abs(way.look(one.tool()).deepest) > 2 * arc_error);
        const bool tunnels = one.tunnels(way.handled, way.deformed, way.from, to);
        through += tunnels ? 1 : 0;

        const Pose frame = turned_about({3, 4, 5}, random_direction(), random_number(-3, 3));
        const auto moved = [&](const Pose& pose) {
            return Pose{.rotation = frame.rotation * pose.rotation,
                        .position = frame.to_world(pose.position)};
        };
        RC_ASSERT(tunnels == one.tunnels(frame.to_world(way.handled), frame.to_world(way.deformed),
                                         moved(way.from), moved(to)));

        const auto reflected = [&](const Pose& pose) {
            return Pose{.rotation = mirror * pose.rotation * mirror, .position = mirror * pose.position};
        };
        RC_ASSERT(tunnels == mirrored.tunnels(mirror * way.handled, mirror * way.deformed,
                                              reflected(way.from), reflected(to)));
        // Back: each of the two motions alone.
        RC_ASSERT(one.tunnels(way.deformed, way.from, to) == one.tunnels(way.deformed, to, way.from));
        RC_ASSERT(one.tunnels(way.handled, way.deformed, to, to) ==
                  one.tunnels(way.deformed, way.handled, to, to));
    }));
    EXPECT_GT(through, 5);
}

}  // namespace
}  // namespace trocar
