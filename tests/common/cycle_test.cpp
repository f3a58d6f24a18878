#include "common/cycle/cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

Pose tip_at(double z) { return {.rotation = Mat3::Identity(), .position = {0.3, 0.4, z}}; }

/// Straight down to the clearance below the tip.
void push_down(const Contact& contact, Response& response) {
    const Vec3 down = -contact.tool.axis();
    for (const Index vertex : contact.collided) {
        const double exit = contact.tool.exit_distance(contact.positions[vertex], down, contact.clearance);
        response.displacements.push_back({vertex, exit * down});
    }
}

class CycleOnSheet : public testing::Test {
  protected:
    void step(Cycle& cycle, const Pose& next, const Handler& handler = push_down) {
        cycle.move(next);
        cycle.detect();
        cycle.handle(handler);
        cycle.deform();
    }

    [[nodiscard]] CycleStart start_at(double z) const { return start_at_rest(organ_, tip_at(z)); }

    const Organ organ_ = make_organ_by_formula("sheet@4mm");
    const Tool tool_ = make_prism(12);
};

TEST_F(CycleOnSheet, MovesDetectsHandlesAndDeforms) {
    Cycle cycle(organ_, tool_, start_at(3), {}, {});
    step(cycle, tip_at(1));
    EXPECT_THAT(cycle.detected().collided, testing::IsEmpty());
    EXPECT_EQ(cycle.positions()[0], organ_.rest.positions[0]);

    step(cycle, tip_at(-2));
    const auto& collided = cycle.detected().collided;
    ASSERT_THAT(collided, testing::Not(testing::IsEmpty()));
    EXPECT_EQ(std::vector<Index>(cycle.held().begin(), cycle.held().end()), collided);
    for (const Index vertex : collided) EXPECT_NEAR(cycle.positions()[vertex].z(), -2.01, 1e-12);
    // The deformation pulls the neighbours along.
    const Index beside = organ_.adjacency.neighbours(collided.front())[0];
    EXPECT_LT(cycle.positions()[beside].z(), -0.01);
}

TEST_F(CycleOnSheet, GivesTheStrategyTheMotionOfTheStep) {
    Cycle cycle(organ_, tool_, start_at(3), {.rate = 60}, {});
    step(cycle, tip_at(-2), [](const Contact& contact, Response&) {
        EXPECT_TRUE(contact.motion.displacement_at({0, 0, 0}).isApprox(Vec3(0, 0, -5)));
        EXPECT_DOUBLE_EQ(contact.dt, 1.0 / 60);
        EXPECT_DOUBLE_EQ(contact.clearance, 0.01);
    });
}

TEST_F(CycleOnSheet, WhatTheToolHoldsFromBeforeStaysWithIt) {
    CycleStart start = start_at(-2);
    const Index beneath = 500, far = 0;
    start.organ.positions[beneath] = {0.3, 0.4, -2.01};  // at the tip, by the clearance
    start.held = {far, beneath};
    Cycle cycle(organ_, tool_, start, {}, {});
    step(cycle, tip_at(-2));
    EXPECT_EQ(cycle.positions()[beneath], Vec3(0.3, 0.4, -2.01));
    EXPECT_TRUE(std::ranges::binary_search(cycle.held(), beneath));
    EXPECT_FALSE(std::ranges::binary_search(cycle.held(), far)) << "it is not at the tool";
}

TEST_F(CycleOnSheet, ContactHoldsAHandledVertexAsLongAsItIsAtTheTool) {
    Cycle cycle(organ_, tool_, start_at(3), {.release = Release::contact}, {});
    step(cycle, tip_at(-2));
    const std::vector<Index> handled(cycle.held().begin(), cycle.held().end());
    const auto still_held = [&] { return std::ranges::includes(cycle.held(), handled); };
    for (int k = 0; k < 5; ++k) {
        step(cycle, tip_at(-2));
        for (const Index vertex : handled) EXPECT_NEAR(cycle.positions()[vertex].z(), -2.01, 1e-12);
        EXPECT_TRUE(still_held());
    }
    step(cycle, tip_at(-2 + 0.005));
    EXPECT_TRUE(still_held()) << "0.015 mm away is within 2 g";
    step(cycle, tip_at(-2 + 0.015));
    EXPECT_FALSE(still_held()) << "0.025 mm away is not";
    EXPECT_GT(cycle.positions()[handled.front()].z(), -2.01) << "it moves again";
}

TEST_F(CycleOnSheet, StepLetsAHandledVertexGoInTheNextStep) {
    Cycle cycle(organ_, tool_, start_at(3), {.release = Release::step}, {});
    step(cycle, tip_at(-2));
    const std::vector<Index> handled(cycle.held().begin(), cycle.held().end());
    ASSERT_GT(handled.size(), 0U);
    step(cycle, tip_at(-2));
    for (const Index vertex : handled) {
        EXPECT_GT(cycle.positions()[vertex].z(), -2) << "it springs back into the tool that stands still";
    }
    // So it is found inside one step later: the flicker that the paper's cycle has.
    step(cycle, tip_at(-2));
    EXPECT_TRUE(std::ranges::includes(cycle.detected().collided, handled));
}

TEST_F(CycleOnSheet, ForcesAndHalfSpacesReachTheDeformation) {
    Cycle cycle(organ_, tool_, start_at(30), {}, {});
    Index inner = 0;
    while (organ_.adjacency.on_boundary(inner)) ++inner;
    const Vec3 rest = organ_.rest.positions[inner];
    step(cycle, tip_at(29), [&](const Contact&, Response& response) {
        response.forces.push_back({inner, Vec3(0, 0, 1e5)});
    });
    EXPECT_GT(cycle.positions()[inner].z(), 0.1);
    for (int k = 0; k < 30; ++k) {
        step(cycle, tip_at(29), [&](const Contact&, Response& response) {
            response.half_spaces.push_back({inner, rest + Vec3(0, 0, 2), Vec3::UnitZ()});
        });
    }
    EXPECT_NEAR(cycle.positions()[inner].z(), 2, 1e-9);
    EXPECT_EQ(cycle.held().size(), 0U) << "neither makes a vertex kinematic";
}

TEST_F(CycleOnSheet, RefusesAnswersThatAreNone) {
    const auto answer = [this](const Handler& handler) {
        Cycle cycle(organ_, tool_, start_at(3), {}, {});
        step(cycle, tip_at(1), handler);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto count = static_cast<Index>(organ_.rest.positions.size());
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.displacements = {{5, Vec3(nan, 0, 0)}};
                 }),
                 std::runtime_error);
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.displacements = {{count, Vec3(1, 0, 0)}};
                 }),
                 std::runtime_error);
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.displacements = {{-1, Vec3(1, 0, 0)}};
                 }),
                 std::runtime_error);
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.displacements = {{5, Vec3(1, 0, 0)}, {5, Vec3(1, 0, 0)}};
                 }),
                 std::runtime_error);
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.forces = {{5, Vec3(0, nan, 0)}};
                 }),
                 std::runtime_error);
    EXPECT_THROW(answer([=](const Contact&, Response& r) {
                     r.half_spaces = {{count, Vec3(0, 0, 0), Vec3(0, 0, 1)}};
                 }),
                 std::runtime_error);
}

TEST_F(CycleOnSheet, RefusesSettingsThatAreNone) {
    EXPECT_THROW(Cycle(organ_, tool_, start_at(3), {.rate = 0}, {}), std::invalid_argument);
    EXPECT_THROW(Cycle(organ_, tool_, start_at(3), {.clearance = 0}, {}), std::invalid_argument);
    EXPECT_THROW(Cycle(organ_, tool_, start_at(3), {}, {.substeps = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
