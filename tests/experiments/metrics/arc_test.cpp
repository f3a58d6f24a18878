#include "experiments/metrics/paths/arc.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "experiments/metrics/paths/paths.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

const Box around = {Vec3::Constant(-60), Vec3::Constant(60)};

Mat3 turned(const Vec3& axis, double angle) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// A screw of the tool, in the world: it turns about the line through `pivot` along `axis` and goes along it.
struct WorldScrew {
    Vec3 pivot, axis;
    double angle, advance;  // rad, mm

    [[nodiscard]] Pose moved(const Pose& pose, double part) const {
        const Mat3 turn = turned(axis, part * angle);
        return {.rotation = turn * pose.rotation,
                .position = turn * (pose.position - pivot) + pivot + part * advance * axis};
    }
};

Pose random_pose() {
    return {.rotation = turned(random_direction(), random_number(-3, 3)), .position = random_point(around)};
}

WorldScrew random_screw(double largest_angle) {
    return {.pivot = random_point(around),
            .axis = random_direction(),
            .angle = random_number(-1, 1) * largest_angle,
            .advance = random_number(-20, 20)};
}

struct SeenWay {
    Pose start;
    WorldScrew screw;
    Vec3 point;  // still, in the world

    [[nodiscard]] Vec3 seen(double part) const { return judged_position(screw.moved(start, part), point); }
    [[nodiscard]] Arc arc() const {
        return {seen(0), seen(1), Turn::seen_from(start, screw.moved(start, 1))};
    }
};

SeenWay random_way(double largest_angle) {
    return {.start = random_pose(), .screw = random_screw(largest_angle), .point = random_point(around)};
}

TEST(Arc, GoesTheWayThatAScrewOfTheToolMakesOfAStillPoint) {
    EXPECT_TRUE(rc::check([] {
        const SeenWay way = random_way(3.1);
        const Arc arc = way.arc();
        RC_ASSERT(arc.at(0) == way.seen(0));
        RC_ASSERT(arc.at(1) == way.seen(1));
        for (const double part : {0.1, 0.25, 0.5, 0.9}) {
            RC_ASSERT((arc.at(part) - way.seen(part)).norm() < 1e-9);
        }
    }));
}

TEST(Arc, IsStraightWhereTheToolDoesNotTurn) {
    const SeenWay way = {.start = {},
                         .screw = {.pivot = {1, 2, 3}, .axis = {0, 0, 1}, .angle = 0, .advance = 8},
                         .point = {4, 5, 6}};
    EXPECT_EQ(way.arc().bulge(), 0);
    EXPECT_EQ(way.arc().chords(1e-3), 1);
    EXPECT_LT((way.arc().at(0.25) - Vec3(4, 5, 4)).norm(), 1e-12);
}

TEST(Arc, HoldsForTurnsThatAreNearlyNone) {
    for (const double angle : {1e-15, 1e-10, 0.99e-8, 1.01e-8, 1e-6}) {
        const SeenWay way = {.start = {},
                             .screw = {.pivot = {50, 0, 0}, .axis = {0, 0, 1}, .angle = angle, .advance = 3},
                             .point = {0, 7, 0}};
        EXPECT_LT((way.arc().at(0.5) - way.seen(0.5)).norm(), 1e-12) << angle;
        EXPECT_EQ(way.arc().chords(1e-3), 1) << angle;
    }
}

TEST(Arc, BulgesByTheSagittaOfACircle) {
    const double angle = 0.1, radius = 40;
    const SeenWay way = {.start = {},
                         .screw = {.pivot = {radius, 0, 0}, .axis = {0, 0, 1}, .angle = angle, .advance = 0},
                         .point = {0, 0, 5}};
    const double sagitta = radius * (1 - std::cos(angle / 2));
    EXPECT_GE(way.arc().bulge(), sagitta);
    EXPECT_LE(way.arc().bulge(), 1.001 * sagitta);
    EXPECT_EQ(way.arc().chords(sagitta / 9), 4) << "three would be just too few";
    EXPECT_EQ(way.arc().chords(1.002 * sagitta / 9), 3);
}

TEST(Arc, ChordsAreWithinTheStatedError) {
    EXPECT_EQ(arc_error, 1e-3) << "one micrometre";
    EXPECT_TRUE(rc::check([] {
        const SeenWay way = random_way(*rc::gen::element(0.01, 0.1, 0.7));
        const Arc arc = way.arc();
        const int chords = arc.chords(arc_error);
        const int chord = static_cast<int>(random_number(0, 0.99) * chords);
        double largest = 0;
        for (int k = 0; k <= 16; ++k) {
            const double along = k / 16.0;
            const Vec3 on_chord =
                (1 - along) * arc.at(double(chord) / chords) + along * arc.at(double(chord + 1) / chords);
            largest = std::max(largest, (way.seen((chord + along) / chords) - on_chord).norm());
        }
        RC_ASSERT(largest <= arc_error + 1e-9);
    }));
}

}  // namespace
}  // namespace trocar
