// order_spread and order_spread_mean, of answers that are made up.

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "common/tool/tool_shapes.h"
#include "judged_steps.h"
#include "square.h"

namespace trocar {
namespace {

using Answers = std::vector<std::vector<VertexDisplacement>>;

constexpr double degree = std::numbers::pi / 180;

Vec3 at_angle(double degrees, double length = 1) {
    return length * Vec3(std::cos(degrees * degree), std::sin(degrees * degree), 0);
}

/// Two fans, of five facets around vertex 0 and of three around vertex 1, whose rims are outside the tool:
/// these two vertices are collided. Beside them, in the tool too, a vertex 2 that is the corner of one facet.
JudgedSteps three_fans() {
    SurfaceMesh mesh{.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .facets = {}};
    const auto add_fan = [&](Index middle, int corners, bool closed) {
        const auto first = static_cast<Index>(mesh.positions.size());
        for (int k = 0; k < corners; ++k) {
            mesh.positions.emplace_back(100 * at_angle(360.0 * k / corners) + 1000 * middle * Vec3::UnitY());
        }
        for (Index k = 0; k < corners - (closed ? 0 : 1); ++k) {
            mesh.facets.push_back({middle, first + k, first + (k + 1) % corners});
        }
    };
    add_fan(0, 5, true);
    add_fan(1, 3, true);
    add_fan(2, 2, false);
    return {make_organ("fans", mesh), make_prism(4, 10, 40)};
}

class OrderSpread : public testing::Test {
  protected:
    [[nodiscard]] Judged step(Answers answers) const {
        Judged step = fans_.step(tip_at(-20), fans_.rest(), fans_.rest(), fans_.rest());
        step.shifted = {.displacements = std::move(answers), .missing = Missing::nothing};
        return step;
    }
    /// Vertex 0 is sent in these directions (degrees).
    [[nodiscard]] Judged sent(const std::vector<double>& angles) const {
        Answers answers;
        for (const double angle : angles) answers.push_back({{0, at_angle(angle)}});
        return step(answers);
    }
    [[nodiscard]] static double largest(const Judged& step) {
        return value("order_spread", Moment::handled, step);
    }
    [[nodiscard]] static double mean(const Judged& step) {
        return value("order_spread_mean", Moment::handled, step);
    }

    const JudgedSteps fans_ = three_fans();
};

TEST_F(OrderSpread, IsTheLargestAngleBetweenAnyTwoDirections) {
    EXPECT_EQ(step({}).collided(), (std::vector<Index>{0, 1, 2}));
    EXPECT_NEAR(largest(sent({20, -15, 55, 0, 30})), 70, 1e-12) << "between the second and the third";
    EXPECT_NEAR(largest(sent({0, 90, 180, 270, 45})), 180, 1e-12) << "not between neighbours alone";
    EXPECT_NEAR(largest(sent({0, 200, 0, 0, 0})), 160, 1e-12) << "never more than 180";
    EXPECT_EQ(largest(sent({33, 33, 33, 33, 33})), 0);
}

TEST_F(OrderSpread, IsExactForAnglesThatTheArcCosineDoesNotSee) {
    EXPECT_NEAR(largest(sent({0, 1e-9, 0, 0, 0})), 1e-9, 1e-15);
    EXPECT_NEAR(largest(sent({0, 180 - 1e-7, 0, 0, 0})), 180 - 1e-7, 1e-12);
}

TEST_F(OrderSpread, DoesNotLookAtLengths) {
    EXPECT_NEAR(largest(step({{{0, at_angle(0, 1e-200)}}, {{0, at_angle(60, 1e9)}}})), 60, 1e-12);
}

TEST_F(OrderSpread, IsOfTheWorstVertexAndOnAverageOfAll) {
    // Vertex 2 has one facet only, and so a spread of 0.
    const Judged both = step({{{0, at_angle(0)}, {1, at_angle(0)}}, {{1, at_angle(100)}, {0, at_angle(20)}}});
    EXPECT_NEAR(largest(both), 100, 1e-12);
    EXPECT_NEAR(mean(both), (20 + 100 + 0) / 3.0, 1e-12);
}

TEST_F(OrderSpread, OfAVertexWithOneFacetIsNothing) {
    const Judged one = step({{{2, at_angle(0)}}, {{2, at_angle(50)}}});
    EXPECT_EQ(largest(one), 0);
    EXPECT_EQ(mean(one), 0) << "the others have no direction and do not count";
}

TEST_F(OrderSpread, EndsWithTheRing) {
    // The ring of vertex 1 has three facets: after three shifts it has been around.
    Answers answers{{{1, at_angle(0)}}, {{1, at_angle(10)}}, {{1, at_angle(20)}}, {{1, at_angle(90)}}};
    EXPECT_NEAR(largest(step(answers)), 20, 1e-12);
    EXPECT_NEAR(mean(step(answers)), 20 / 2.0, 1e-12);
}

TEST_F(OrderSpread, HasNoDirectionWhereAVertexIsNotMoved) {
    const Judged once =
        step({{{0, at_angle(0)}, {1, at_angle(0)}}, {{1, at_angle(30)}}, {{0, Vec3::Zero()}}});
    EXPECT_NEAR(mean(once), 30 / 2.0, 1e-12) << "of vertices 1 and 2";
    const Judged twice = step({{{0, at_angle(0)}}, {}, {{0, Vec3::Zero()}}, {}, {{0, at_angle(40)}}});
    EXPECT_NEAR(largest(twice), 40, 1e-12);
    EXPECT_NEAR(mean(twice), 40 / 2.0, 1e-12) << "of vertices 0 and 2; vertex 1 does not count";
}

TEST_F(OrderSpread, IsOfCollidedVerticesAlone) {
    const Index outside = 3;
    const Judged moved = step({{{outside, at_angle(0)}}, {{outside, at_angle(120)}}});
    EXPECT_EQ(largest(moved), 0);
}

TEST_F(OrderSpread, SaysWhyItIsMissing) {
    const auto why = [](const Judged& step) {
        EXPECT_EQ(why_missing("order_spread", Moment::handled, step),
                  why_missing("order_spread_mean", Moment::handled, step));
        return why_missing("order_spread", Moment::handled, step);
    };
    EXPECT_EQ(why(fans_.step(tip_at(5), fans_.rest(), fans_.rest(), fans_.rest())),
              Missing::no_vertex_collided);
    EXPECT_EQ(why(fans_.step(tip_at(-20), fans_.rest(), fans_.rest(), fans_.rest())), Missing::no_answer)
        << "nobody was asked";
    Judged keeping = step({});
    keeping.shifted.missing = Missing::keeps_state;
    EXPECT_EQ(why(keeping), Missing::keeps_state);

    // Every vertex of a tetrahedron has three facets; one is sent somewhere, once.
    const SurfaceMesh tetrahedron{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  .facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    const JudgedSteps closed(make_organ("tetrahedron", tetrahedron), make_prism(4, 10, 40));
    Judged still = closed.step(tip_at(-20), closed.rest(), closed.rest(), closed.rest());
    still.shifted = {.displacements = {{{0, at_angle(0)}}, {}, {}}, .missing = Missing::nothing};
    EXPECT_EQ(why(still), Missing::no_direction);
}

class Asked : public testing::Test {
  protected:
    /// How often `ask` is called in each of four steps that are judged so.
    [[nodiscard]] std::vector<int> calls(const std::string& metrics, int every) const {
        const std::vector<Vec3>& rest = square_.steps().rest();
        Judge judge(square_.steps().state(rest, tip_at(-20)),
                    {.metrics = choose_metrics(metrics), .region = {}, .every = every});
        std::vector<int> calls;
        for (int step = 0; step < 4; ++step) {
            int now = 0;
            judge.before(rest, tip_at(-20));
            judge.handled(rest, 0, [&] {
                ++now;
                return ShiftedAnswers{.displacements = {}, .missing = Missing::keeps_state};
            });
            judge.deformed(rest);
            calls.push_back(now);
        }
        return calls;
    }

    const Square square_;
};

TEST_F(Asked, OnceAStepWhereItIsChosen) {
    EXPECT_EQ(calls("order_spread", 1), (std::vector{1, 1, 1, 1}));
    EXPECT_EQ(calls("depth_max,order_spread,order_spread_mean", 1), (std::vector{1, 1, 1, 1}));
    EXPECT_EQ(calls("fast", 1), (std::vector{0, 0, 0, 0}));
}

TEST_F(Asked, InSampledStepsOnly) { EXPECT_EQ(calls("order_spread_mean", 2), (std::vector{0, 1, 0, 1})); }

TEST_F(Asked, AnswersAreOfTheirStep) {
    const std::vector<Vec3>& rest = square_.steps().rest();
    Judge judge(square_.steps().state(rest, tip_at(-20)),
                {.metrics = choose_metrics("order_spread"), .region = {}, .every = 1});
    const auto missing_after = [&](const AskShifted& ask) {
        judge.before(rest, tip_at(-20));
        judge.handled(rest, 0, ask);
        judge.deformed(rest);
        return judge.values().at(0).missing;
    };
    const AskShifted answer = [] {
        return ShiftedAnswers{.displacements = {{{0, at_angle(0)}}, {{0, at_angle(1)}}},
                              .missing = Missing::nothing};
    };
    EXPECT_EQ(missing_after(answer), Missing::nothing);
    EXPECT_EQ(missing_after({}), Missing::no_answer) << "not those of the step before";
}

}  // namespace
}  // namespace trocar
