#include "experiments/scenes/reference_state.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/deformation/xpbd.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/prepared_scene.h"
#include "stage.h"

namespace trocar {
namespace {

class ReferenceState : public testing::TestWithParam<std::string> {
  protected:
    const Stage stage_{GetParam()};
    const SceneInputs inputs_ = stage_.inputs(100, 3);
    const PreparedScene scene_ = prepare_scene(find_scene("extraction"), inputs_);
};
INSTANTIATE_TEST_SUITE_P(Organs, ReferenceState, testing::Values("sphere@5mm", "sheet@5mm"));

TEST_P(ReferenceState, TheToolIsInTheOrganAndNoVertexIsInTheTool) {
    const SurfaceQueries tool(stage_.tool.mesh);
    const auto& positions = scene_.start.organ.positions;
    for (const Vec3& position : positions) {
        EXPECT_FALSE(tool.contains(judged_position(scene_.start.tool, position)));
    }
    double most = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        most = std::max(most, (positions[v] - inputs_.organ.rest.positions[v]).norm());
    }
    EXPECT_GT(most, 7) << "the organ is dented by about the 8 mm that the tool is deep";
}

TEST_P(ReferenceState, IsAnEquilibrium) {
    const CycleStart& start = scene_.start;
    XpbdIntegrator integrator(surface_springs(inputs_.organ, {}), start.organ, {.dt = inputs_.dt});
    const StepLoad load{.kinematic = start.held, .forces = {}, .half_spaces = {}};
    for (int step = 0; step < 30; ++step) integrator.step(load);
    for (std::size_t v = 0; v < start.organ.positions.size(); ++v) {
        EXPECT_LT((integrator.state().positions[v] - start.organ.positions[v]).norm(), 0.01)
            << "less than the clearance in a second";
    }
}

TEST_P(ReferenceState, WhatIsAtTheToolIsHeldFromTheFirstStepOn) {
    ASSERT_FALSE(scene_.start.held.empty());
    Cycle cycle(inputs_.organ, inputs_.tool, scene_.start, {}, {});
    cycle.move(scene_.start.tool);
    cycle.detect();
    EXPECT_TRUE(cycle.detected().collided.empty());
    EXPECT_FALSE(cycle.held().empty());
    EXPECT_TRUE(std::ranges::includes(scene_.start.held, cycle.held()));
}

TEST_P(ReferenceState, DoesNotDependOnTheSpeedAndRepeats) {
    const PreparedScene faster = prepare_scene(find_scene("extraction"), stage_.inputs(400, 3));
    EXPECT_EQ(faster.start.organ.positions, scene_.start.organ.positions);
    EXPECT_EQ(faster.start.held, scene_.start.held);
}

TEST_P(ReferenceState, VerticesInsideWentAlongTheWayIn) {
    // What the tool holds at its flat tip lies straight below it, by the clearance.
    const Vec3 in = -scene_.placement.normal;
    std::size_t at_tip = 0;
    for (const Index v : scene_.start.held) {
        const double below = (scene_.start.organ.positions[v] - scene_.start.tool.position).dot(in);
        EXPECT_LT(below, 0.01 + 1e-9);
        if (below > 0.01 - 1e-9) ++at_tip;
    }
    EXPECT_GT(at_tip, 0U);
}

}  // namespace
}  // namespace trocar
