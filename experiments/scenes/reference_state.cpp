#include "experiments/scenes/reference_state.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "common/deformation/xpbd.h"
#include "common/detection/detector.h"

namespace trocar {
namespace {

constexpr double longest_step = 0.5;  // mm, of the tool on its way in
constexpr int most_steps = 5000;      // of the deformation, until the organ has to be at rest

// The organ counts as at rest when no vertex moves by more than this part of the clearance in a step; on the
// way in it need not be as quiet as at the end.
constexpr double quiet_on_the_way = 1, quiet_at_the_end = 0.01;

/// The organ around a tool that is pushed in.
class Pushed {
  public:
    Pushed(const SceneInputs& inputs, const Pose& start, const Vec3& direction, double clearance,
           const SpringSettings& springs)
        : tool_(inputs.tool),
          direction_(direction),
          clearance_(clearance),
          detector_(inputs.organ),
          integrator_(
              surface_springs(inputs.organ, springs), start_at_rest(inputs.organ, start).organ,
              {.dt = inputs.dt, .damping = springs.damping, .substeps = springs.substeps, .still = 0}),
          pose_(start) {}

    /// Puts the tool there, clears it and lets the organ relax until it is quiet and no vertex is inside.
    void push_to(const Pose& pose, double quiet) {
        pose_ = pose;
        for (int step = 0; step < most_steps; ++step) {
            const bool cleared = clear();
            const std::vector<Vec3> before = integrator_.state().positions;
            const std::vector<Index> held(held_.begin(), held_.end());
            integrator_.step({.kinematic = held, .forces = {}, .half_spaces = {}});
            double longest = 0;
            for (std::size_t v = 0; v < before.size(); ++v) {
                longest = std::max(longest, (integrator_.state().positions[v] - before[v]).norm());
            }
            if (cleared && longest <= quiet * clearance_ && clear()) return;
        }
        throw std::runtime_error(fmt::format(
            "the organ did not come to rest around the inserted tool within {} steps", most_steps));
    }

    [[nodiscard]] CycleStart start() const {
        const std::vector<Vec3>& positions = integrator_.state().positions;
        return {.tool = pose_,
                .organ = {.positions = positions,
                          .velocities = std::vector<Vec3>(positions.size(), Vec3::Zero())},
                .held = {held_.begin(), held_.end()}};
    }

  private:
    /// Moves the vertices that are inside along the tool's way to the exit. @returns whether there was none
    bool clear() {
        const PlacedTool tool(tool_, pose_);
        const std::vector<Vec3>& positions = integrator_.state().positions;
        detector_.follow(integrator_.moved_patches(), positions);
        detector_.detect(positions, tool_, ToolMotion(pose_, pose_), found_);
        for (const Index vertex : found_.collided) {
            const Vec3& position = positions[vertex];
            const double exit = tool.exit_distance(position, direction_, clearance_);
            integrator_.put(vertex, position + exit * direction_);
            held_.insert(vertex);
        }
        return found_.collided.empty();
    }

    const Tool& tool_;
    Vec3 direction_;
    double clearance_;
    Detector detector_;
    XpbdIntegrator integrator_;
    Pose pose_;
    std::set<Index> held_;
    Detected found_;
};

}  // namespace

CycleStart reference_state(const SceneInputs& inputs, const Pose& start, const Insertion& insertion,
                           double clearance, const SpringSettings& springs) {
    Pushed organ(inputs, start, insertion.direction, clearance, springs);
    const auto steps = static_cast<int>(std::ceil(insertion.length / longest_step));
    for (int step = 1; step <= steps; ++step) {
        Pose pose = start;
        pose.position -= insertion.length * (steps - step) / steps * insertion.direction;
        organ.push_to(pose, step < steps ? quiet_on_the_way : quiet_at_the_end);
    }
    return organ.start();
}

}  // namespace trocar
