// What every scene of the list has to keep to.

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "experiments/scenes/placement.h"
#include "experiments/scenes/window.h"
#include "stage.h"

namespace trocar {
namespace {

constexpr std::size_t rest_steps = 30;  // one second

/// The first of a few small organs on which the scene has a place.
const Stage& stage_for(const SceneEntry& scene) {
    static const std::array<Stage, 3> stages{Stage("sphere@10mm"), Stage("tube@10mm"), Stage("cleft@12mm")};
    const auto* suited = std::ranges::find_if(
        stages, [&](const Stage& one) { return unsuited(scene, one.inputs(100, 1)).empty(); });
    if (suited == stages.end()) throw std::runtime_error("no organ here has a place for " + scene.name);
    return *suited;
}

bool same(const Pose& a, const Pose& b) { return a.position == b.position && a.rotation == b.rotation; }

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const SceneEntry& scene : all_scenes()) all.push_back(scene.name);
    return all;
}

class EveryScene : public testing::TestWithParam<std::string> {
  protected:
    struct Laid {
        SceneInputs inputs;
        Placement at;
        ScenePlan plan;
        std::vector<bool> window;  // the start, then each step
    };

    [[nodiscard]] SceneInputs inputs(double speed, std::uint64_t seed) const {
        SceneInputs all = stage_.inputs(speed, seed);
        if (scene_.needs_recording) all.recording = &recording_;
        return all;
    }
    [[nodiscard]] Laid lay_out(double speed, std::uint64_t seed) const {
        const SceneInputs given = inputs(speed, seed);
        const Placement at = scene_.place(given);
        ScenePlan plan = scene_.plan(given, at);
        std::vector<Pose> poses{plan.start};
        poses.insert(poses.end(), plan.poses.begin(), plan.poses.end());
        return {given, at, std::move(plan), window_of(given, poses)};
    }

    const SceneEntry& scene_ = find_scene(GetParam());
    const Stage& stage_ = stage_for(scene_);
    const Recording recording_{
        .motion = parse_recorded_motion("t,x,y,z,qw,qx,qy,qz\n0,0,0,3,1,0,0,0\n0.1,0,0,-6,1,0,0,0\n"
                                        "0.25,0,0,3,1,0,0,0\n"),
        .frame = Recording::Frame::entry};
};
INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(names()),
                         [](const auto& tested) { return tested.param; });

TEST_P(EveryScene, IsMadeOfRigidMotions) {
    for (const double speed : {20.0, 400.0}) {
        for (const Pose& pose : lay_out(speed, 1).plan.poses) {
            ASSERT_TRUE(pose.position.allFinite());
            ASSERT_TRUE((pose.rotation * pose.rotation.transpose()).isApprox(Mat3::Identity(), 1e-12));
            ASSERT_GT(pose.rotation.determinant(), 0) << "not a mirror image";
        }
    }
}

TEST_P(EveryScene, StartsClearOfTheOrganOrWithAnInsertion) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto [inputs, at, plan, window] = lay_out(100, seed);
        EXPECT_EQ(window.front(), plan.insertion.has_value());
        if (!plan.insertion) continue;
        EXPECT_NEAR(plan.insertion->direction.norm(), 1, 1e-12);
        Pose outside = plan.start;
        outside.position -= plan.insertion->length * plan.insertion->direction;
        EXPECT_FALSE(window_of(inputs, {outside}).front()) << "it was inserted from where it was clear";
    }
}

TEST_P(EveryScene, MeetsTheOrganLeavesItAndRests) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Laid laid = lay_out(100, seed);
        EXPECT_GT(std::ranges::count(laid.window, true), 1);
        EXPECT_FALSE(laid.window.back());
        const std::vector<Pose>& poses = laid.plan.poses;
        ASSERT_GT(poses.size(), rest_steps);
        for (std::size_t k = poses.size() - rest_steps; k < poses.size(); ++k) {
            EXPECT_TRUE(same(poses[k], poses.back())) << "it rests for the last second";
        }
    }
}

TEST_P(EveryScene, IsTheSameForTheSameSeedOnly) {
    const Laid one = lay_out(100, 3), other = lay_out(100, 4), again = lay_out(100, 3);
    EXPECT_TRUE(std::ranges::equal(one.plan.poses, again.plan.poses, same));
    EXPECT_TRUE(same(one.plan.start, again.plan.start));
    EXPECT_FALSE(same(one.plan.start, other.plan.start));
}

TEST_P(EveryScene, BeginsAtTheSamePlaceAtEverySpeed) {
    EXPECT_TRUE(same(lay_out(20, 2).plan.start, lay_out(400, 2).plan.start));
}

}  // namespace
}  // namespace trocar
