#include <cmath>
#include <stdexcept>

#include "experiments/scenes/distances.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"

namespace trocar::scenes {
namespace {

// A recording says itself how deep it goes: any point with something below it will do.
constexpr PlacementRule anywhere{.depth = 0};

ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    if (inputs.recording == nullptr) throw std::invalid_argument("the scene recorded needs a recording");
    const RecordedMotion& motion = inputs.recording->motion;
    const Pose frame =
        inputs.recording->frame == Recording::Frame::entry ? upright_pose(at, at.entry) : Pose{};
    const auto pose_at = [&](double time) {
        const Pose pose = motion.at(time);
        return Pose{.rotation = frame.rotation * pose.rotation, .position = frame.to_world(pose.position)};
    };
    ScenePlan plan{.start = pose_at(0), .poses = {}, .insertion = {}};
    const auto moving = static_cast<std::size_t>(std::ceil(motion.duration() / inputs.dt - 1e-9));
    const auto resting = static_cast<std::size_t>(std::lround(rest_s / inputs.dt));
    for (std::size_t k = 1; k <= moving + resting; ++k) {
        plan.poses.push_back(pose_at(static_cast<double>(k) * inputs.dt));
    }
    return plan;
}

}  // namespace

SceneEntry recorded() {
    return {.name = "recorded",
            .summary = "poses from a CSV file (t, x, y, z, qw, qx, qy, qz), at their own speed, rest",
            .place = [](const SceneInputs& inputs) { return place(inputs, anywhere); },
            .plan = plan,
            .needs_recording = true};
}

}  // namespace trocar::scenes
