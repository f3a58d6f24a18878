// What a step of a sleeping organ makes of it differs from the full simulation of the same step, from the
// same state, by less than a tenth of the clearance.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "common/cycle/cycle.h"
#include "experiments/scenes/prepared_scene.h"
#include "stage.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

double largest_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
    return largest;
}

CycleStart as_it_is(const Cycle& cycle) {
    return {.tool = cycle.tool().pose(),
            .organ = {.positions = {cycle.positions().begin(), cycle.positions().end()},
                      .velocities = {cycle.velocities().begin(), cycle.velocities().end()}},
            .held = {cycle.held().begin(), cycle.held().end()}};
}

/// Takes the step. @returns how many vertices the tool holds or found inside
std::size_t step(Cycle& cycle, const Pose& pose, Strategy& strategy) {
    cycle.move(pose);
    cycle.detect();
    cycle.handle([&](const Contact& contact, Response& response) { strategy.handle(contact, response); });
    cycle.deform();
    return cycle.detected().collided.size() + cycle.held().size();
}

struct Setting {
    std::string name, organ, scene, strategy;
    double speed;
    CycleSettings cycle;
    SpringSettings springs;
};

void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

class Sleep : public testing::TestWithParam<Setting> {
  protected:
    [[nodiscard]] PreparedScene prepare() const {
        SceneInputs inputs = stage_.inputs(GetParam().speed, 3);
        inputs.dt = GetParam().cycle.dt();
        return prepare_scene(find_scene(GetParam().scene), inputs, GetParam().cycle.clearance,
                             GetParam().springs);
    }
    [[nodiscard]] SpringSettings full() const {
        SpringSettings springs = GetParam().springs;
        springs.sleep = false;
        return springs;
    }
    [[nodiscard]] Cycle cycle(const CycleStart& start, const SpringSettings& springs) const {
        return {stage_.organ, stage_.tool, start, GetParam().cycle, springs};
    }

    const Stage stage_{GetParam().organ};
    const double clearance_ = GetParam().cycle.clearance;
};

TEST_P(Sleep, AStepIsThatOfTheFullSimulationFromTheSameState) {
    const PreparedScene scene = prepare();
    const auto strategy = make_strategy(GetParam().strategy);
    Cycle sleeping = cycle(scene.start, GetParam().springs);
    std::size_t touched = scene.start.held.size();
    double most_asleep = 0;
    for (std::size_t k = 0; k < scene.poses.size(); ++k) {
        Cycle once_in_full = cycle(as_it_is(sleeping), full());
        touched += step(sleeping, scene.poses[k], *strategy);
        step(once_in_full, scene.poses[k], *strategy);
        ASSERT_LE(largest_distance(sleeping.positions(), once_in_full.positions()), clearance_ / 10)
            << "step " << k;
        most_asleep = std::max(most_asleep, 1 - sleeping.awake_share());
    }
    EXPECT_GT(touched, 0U);
    EXPECT_GT(most_asleep, 0.5) << "something did sleep";
}

std::vector<Setting> settings() {
    SpringSettings light, stiff;
    light.damping = 20;
    stiff.edge_stiffness *= 10;
    stiff.rest_stiffness *= 10;
    return {{"slow", "sphere@4mm", "penetration", "nearest-face", 20, {}, {}},
            {"moderate", "sphere@3mm", "penetration", "fuzzy-per-vertex", 100, {}, {}},
            {"rapid", "sphere@4mm", "penetration", "joint-vertex", 400, {}, {}},
            {"released", "sphere@4mm", "penetration", "nearest-face", 20, {.release = Release::step}, {}},
            {"sliding", "liver@5mm", "sliding", "fuzzy-per-vertex", 100, {}, {}},
            {"cutting", "cleft@5mm", "cutting", "tool-facet", 100, {}, {}},
            {"pivot", "sphere@4mm", "pivot", "cylinder-axis", 100, {}, {}},
            {"coming_out", "gallbladder@3mm", "extraction", "nearest-face", 100, {}, {}},
            {"open", "sheet@3mm", "penetration", "average-plane", 20, {}, {}},
            {"haptic", "sphere@5mm", "penetration", "nearest-face", 100, {.rate = 1000}, {}},
            {"coarse_clearance", "sphere@4mm", "penetration", "nearest-face", 100, {.clearance = 0.1}, {}},
            {"swinging", "sphere@4mm", "penetration", "nearest-face", 100, {}, light},
            {"stiff", "sphere@4mm", "penetration", "nearest-face", 100, {}, stiff}};
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Sleep, testing::ValuesIn(settings()),
                         [](const testing::TestParamInfo<Setting>& setting) { return setting.param.name; });

}  // namespace
}  // namespace trocar
