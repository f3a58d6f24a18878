#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/scenes/placement.h"
#include "experiments/scenes/prepared_scene.h"
#include "stage.h"

namespace trocar {
namespace {

constexpr double dt = 1.0 / 30;
constexpr std::size_t hold_steps = 15, rest_steps = 30;  // half a second and one, at 30 Hz

/// A scene laid out on a sphere, and where its tip is over the entry point.
struct Laid {
    Laid(const std::string& name, double speed, std::uint64_t seed = 2)
        : inputs(stage().inputs(speed, seed)),
          at(find_scene(name).place(inputs)),
          plan(find_scene(name).plan(inputs, at)) {}

    static const Stage& stage() {
        static const Stage one("sphere@6mm");
        return one;
    }
    [[nodiscard]] Vec3 over_entry(const Pose& pose) const { return pose.position - at.entry; }
    [[nodiscard]] double height(const Pose& pose) const { return at.normal.dot(over_entry(pose)); }
    [[nodiscard]] double along(const Pose& pose) const { return at.tangent.dot(over_entry(pose)); }
    [[nodiscard]] std::size_t steps_at(double wanted_height) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            plan.poses, [&](const Pose& pose) { return std::abs(height(pose) - wanted_height) < 1e-9; }));
    }
    [[nodiscard]] double lowest() const {
        double low = height(plan.start);
        for (const Pose& pose : plan.poses) low = std::min(low, height(pose));
        return low;
    }
    void expect_upright() const {
        for (const Pose& pose : plan.poses) EXPECT_TRUE(pose.rotation.col(2).isApprox(at.normal, 1e-12));
    }
    /// Constant speed but for the last step of a segment, and the phase in the first step.
    void expect_walked() const {
        double longest = 0;
        for (std::size_t k = 1; k < plan.poses.size(); ++k) {
            longest = std::max(longest, (plan.poses[k].position - plan.poses[k - 1].position).norm());
        }
        EXPECT_LE(longest, inputs.speed * dt + 1e-9);
        EXPECT_LE((plan.poses[0].position - plan.start.position).norm(), at.phase * inputs.speed * dt + 1e-9);
    }

    SceneInputs inputs;
    Placement at;
    ScenePlan plan;
};

class AtSpeed : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Scenes, AtSpeed, testing::Values(20, 100, 400, 2000));

TEST_P(AtSpeed, PenetrationGoesInTo12mmHoldsComesBackAndRests) {
    const Laid scene("penetration", GetParam());
    EXPECT_NEAR(scene.height(scene.plan.start), 3, 1e-12);
    EXPECT_NEAR(scene.lowest(), -12, 1e-12) << "the same at every speed";
    EXPECT_EQ(scene.steps_at(-12), 1 + hold_steps) << "arrival and half a second";
    EXPECT_EQ(scene.steps_at(3), 1 + rest_steps);
    for (const Pose& pose : scene.plan.poses) {
        EXPECT_LT((scene.over_entry(pose) - scene.height(pose) * scene.at.normal).norm(), 1e-9);
    }
    EXPECT_FALSE(scene.plan.insertion);
    scene.expect_upright();
    scene.expect_walked();
}

TEST_P(AtSpeed, ExtractionStarts8mmDeepAndLeaves) {
    const Laid scene("extraction", GetParam());
    EXPECT_NEAR(scene.height(scene.plan.start), -8, 1e-12);
    ASSERT_TRUE(scene.plan.insertion);
    EXPECT_TRUE(scene.plan.insertion->direction.isApprox(-scene.at.normal));
    EXPECT_NEAR(scene.plan.insertion->length, 11, 1e-12) << "from 3 mm clear";
    for (std::size_t k = 1; k < scene.plan.poses.size(); ++k) {
        EXPECT_GE(scene.height(scene.plan.poses[k]), scene.height(scene.plan.poses[k - 1]) - 1e-12);
    }
    EXPECT_EQ(scene.steps_at(3), 1 + rest_steps);
    scene.expect_upright();
    scene.expect_walked();
}

TEST_P(AtSpeed, ObliqueGoesInAt45Degrees) {
    const Laid scene("oblique", GetParam());
    EXPECT_NEAR(scene.height(scene.plan.start), 3, 1e-12);
    for (const Pose& pose : scene.plan.poses) {
        EXPECT_NEAR(scene.along(pose), -scene.height(pose), 1e-9) << "as far aside as down";
    }
    EXPECT_NEAR(scene.lowest(), -12, 1e-12);
    EXPECT_EQ(scene.steps_at(-12), 1 + hold_steps);
    EXPECT_EQ(scene.steps_at(3), 1 + rest_steps);
    scene.expect_upright();
    scene.expect_walked();
}

TEST_P(AtSpeed, TwistingTurnsHalfwayAboutTheAxisAndLeaves) {
    const Laid scene("twisting", GetParam());
    EXPECT_NEAR(scene.height(scene.plan.start), -8, 1e-12);
    EXPECT_TRUE(scene.plan.insertion);
    double before = 0;
    for (const Pose& pose : scene.plan.poses) {
        const Eigen::AngleAxisd turned(pose.rotation * scene.plan.start.rotation.transpose());
        EXPECT_GE(turned.angle(), before - 1e-9);
        EXPECT_LE((turned.angle() - before) * Laid::stage().tool.radius, GetParam() * dt + 1e-6);
        before = turned.angle();
    }
    EXPECT_NEAR(before, std::numbers::pi, 1e-9);
    EXPECT_GE(scene.steps_at(-8), hold_steps);
    EXPECT_EQ(scene.steps_at(3), 1 + rest_steps);
    scene.expect_upright();
}

TEST_P(AtSpeed, BreathingMovesTheOrganOntoATheToolThatIsHeld) {
    const Laid scene("breathing", GetParam());
    EXPECT_NEAR(scene.height(scene.plan.start), 3, 1e-12);
    double fastest = 0;
    for (std::size_t k = 1; k < scene.plan.poses.size(); ++k) {
        const Vec3 moved = scene.plan.poses[k].position - scene.plan.poses[k - 1].position;
        EXPECT_LT(moved.cross(scene.at.normal).norm(), 1e-9) << "along n only";
        fastest = std::max(fastest, moved.norm() / dt);
    }
    EXPECT_LE(fastest, GetParam() * (1 + 1e-9));
    EXPECT_GE(scene.lowest(), -12 - 1e-9);
    if (GetParam() <= 100) {
        EXPECT_NEAR(scene.lowest(), -12, 1);  // as near as the steps come to the moment of the turn
        EXPECT_GT(fastest, 0.9 * GetParam());
    }
    EXPECT_EQ(scene.steps_at(3), 1 + rest_steps);
    scene.expect_upright();
}

TEST(Thin, IsPenetrationElsewhere) {
    const SceneInputs inputs = Laid::stage().inputs(100, 3);
    const Placement at = find_scene("penetration").place(inputs);
    const ScenePlan a = find_scene("penetration").plan(inputs, at), b = find_scene("thin").plan(inputs, at);
    ASSERT_EQ(a.poses.size(), b.poses.size());
    for (std::size_t k = 0; k < a.poses.size(); ++k) EXPECT_EQ(a.poses[k].position, b.poses[k].position);
}

TEST(Cutting, GoesIntoTheMouthNearItsLineAndNearlyStraight) {
    Organ organ = make_organ_by_formula("sphere@8mm");
    organ.mouth = Mouth{.point = {0, 0, 40}, .normal = Vec3::UnitZ(), .along = Vec3::UnitY(), .length = 20};
    double least_tilt = 90, largest_tilt = 0, largest_offset = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const SceneInputs inputs{.organ = organ,
                                 .organ_queries = Laid::stage().queries,
                                 .tool = Laid::stage().tool,
                                 .speed = 100,
                                 .dt = dt,
                                 .seed = seed};
        const Placement at = find_scene("cutting").place(inputs);
        const double offset = std::abs(at.entry.x());  // across the mouth
        EXPECT_LE(offset, 0.2 * 4 + 1e-12);
        EXPECT_LE(std::abs(at.entry.y()), 20 * 0.25 + 1e-12);
        EXPECT_EQ(at.entry.z(), 40);
        const double tilt = std::acos(std::min(1.0, at.normal.z())) * 180 / std::numbers::pi;
        EXPECT_LE(tilt, 5 + 1e-9);
        least_tilt = std::min(least_tilt, tilt);
        largest_tilt = std::max(largest_tilt, tilt);
        largest_offset = std::max(largest_offset, offset);
        const ScenePlan plan = find_scene("cutting").plan(inputs, at);
        double deepest = 0;
        for (const Pose& pose : plan.poses)
            deepest = std::min(deepest, at.normal.dot(pose.position - at.entry));
        EXPECT_NEAR(deepest, -15, 1e-9);
    }
    EXPECT_LT(least_tilt, 1);
    EXPECT_GT(largest_tilt, 4);
    EXPECT_GT(largest_offset, 0.6);
}

TEST(Pivot, TheAxisPassesThroughTheIncisionThroughout300Steps) {
    const Laid scene("pivot", 100);
    const Vec3 incision = scene.at.entry + 100 * scene.at.normal;
    ASSERT_GE(scene.plan.poses.size(), 300 + rest_steps);
    double deepest = 0, furthest_roll = 0;
    for (std::size_t k = 0; k < 300; ++k) {
        const Pose& pose = scene.plan.poses[k];
        EXPECT_LT((incision - pose.position).cross(pose.rotation.col(2)).norm(), 1e-9);
        EXPECT_LT(std::acos(pose.rotation.col(2).dot(scene.at.normal)), 0.2);
        deepest = std::max(deepest, (incision - pose.position).norm() - 100);
        furthest_roll = std::max(furthest_roll, std::acos(pose.rotation.col(0).dot(scene.at.tangent)));
    }
    EXPECT_LE(deepest, 10);
    EXPECT_GT(deepest, 5);
    EXPECT_GT(furthest_roll, 0.1);
    const Pose& last = scene.plan.poses.back();
    EXPECT_GT(scene.height(last), 0) << "it rests outside";
    EXPECT_EQ(scene.plan.poses[scene.plan.poses.size() - 1 - rest_steps].position, last.position);
}

TEST(Pivot, ItsSpeedIsTheTipsRootMeanSquare) {
    for (const double speed : {20.0, 100.0}) {
        double mean = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Laid scene("pivot", speed, seed);
            double squares = 0;
            for (std::size_t k = 1; k < 300; ++k) {
                squares += (scene.plan.poses[k].position - scene.plan.poses[k - 1].position).squaredNorm();
            }
            mean += std::sqrt(squares / 299) / dt / 20;
        }
        // The root mean square over whole periods is exact; 300 steps are a part of them.
        EXPECT_NEAR(mean, speed, 0.05 * speed);
    }
}

TEST(Pivot, AnotherSeedIsAnotherMotion) {
    const Laid a("pivot", 100, 1), b("pivot", 100, 2);
    const auto pitch = [](const Laid& scene, std::size_t k) {
        return scene.plan.poses[k].rotation.col(2).dot(scene.at.tangent);
    };
    EXPECT_GT(std::abs(pitch(a, 100) - pitch(b, 100)), 1e-3);
}

TEST(Recorded, PlaysTheFileInTheFrameItIsMadeFor) {
    Recording recording{
        .motion = parse_recorded_motion("t,x,y,z,qw,qx,qy,qz\n0,0,0,3,1,0,0,0\n0.1,0,0,-6,1,0,0,0\n"
                                        "0.25,0,0,3,1,0,0,0\n"),
        .frame = Recording::Frame::entry};
    SceneInputs inputs = Laid::stage().inputs(999, 4);
    inputs.recording = &recording;
    const SceneEntry& entry = find_scene("recorded");
    const Placement at = entry.place(inputs);
    const ScenePlan plan = entry.plan(inputs, at);
    ASSERT_EQ(plan.poses.size(), 8 + rest_steps) << "a quarter of a second is seven and a half steps";
    EXPECT_TRUE(plan.start.position.isApprox(at.entry + 3 * at.normal, 1e-12));
    EXPECT_TRUE(plan.poses[2].position.isApprox(at.entry - 6 * at.normal, 1e-12)) << "at 0.1 s";
    EXPECT_TRUE(plan.poses.back().position.isApprox(at.entry + 3 * at.normal, 1e-12));

    recording.frame = Recording::Frame::organ;
    const ScenePlan world = entry.plan(inputs, at);
    EXPECT_TRUE(world.poses[2].position.isApprox(Vec3(0, 0, -6), 1e-12));
}

TEST(PreparedScene, ItsWindowIsWhereTheToolMeetsTheOrganAtRest) {
    const SceneInputs inputs = Laid::stage().inputs(100, 2);
    const PreparedScene scene = prepare_scene(find_scene("penetration"), inputs);
    ASSERT_EQ(scene.window.size(), scene.poses.size());
    for (std::size_t k = 0; k < scene.poses.size(); ++k) {
        const double height = scene.placement.normal.dot(scene.poses[k].position - scene.placement.entry);
        // The flat end meets the sphere a little before or after its middle does.
        if (std::abs(height) > 0.5) {
            EXPECT_EQ(scene.window[k], height < 0) << height;
        }
    }
}

TEST(Scenes, AreFoundByName) {
    EXPECT_EQ(find_scene("penetration").name, "penetration");
    EXPECT_THROW(find_scene("penetratoin"), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
