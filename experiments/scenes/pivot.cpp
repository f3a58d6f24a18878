#include "common/tool/pivot.h"

#include <array>
#include <cmath>
#include <numbers>

#include "common/tool/walk.h"
#include "experiments/scenes/distances.h"
#include "experiments/scenes/draws.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"

namespace trocar::scenes {
namespace {

constexpr double incision_height = 100;  // mm above the entry point
constexpr double depth = 10;             // mm, at most
constexpr double swing = 0.1;            // rad, largest yaw and pitch: 10 mm at the tip
constexpr double largest_roll = std::numbers::pi / 2;
constexpr int steps = 300;

/// A smooth wave of period 2π in [−1, 1], zero at 0, drawn by the seed.
class Wave {
  public:
    Wave(std::uint64_t seed, std::uint64_t number) {
        // Counters 0 to 2^63 belong to the placement.
        const std::uint64_t counter = (std::uint64_t{1} << 63U) + 2 * number;
        const auto heights = draw(seed, counter), phases = draw(seed, counter + 1);
        double sum = 0;
        for (std::size_t k = 0; k < parts; ++k) sum += heights.at(k);
        for (std::size_t k = 0; k < parts; ++k) {
            heights_.at(k) = heights.at(k) / sum;
            phases_.at(k) = 2 * std::numbers::pi * phases.at(k);
        }
    }
    [[nodiscard]] double at(double angle) const {
        double value = 0;
        for (std::size_t k = 0; k < parts; ++k) {
            const double phase = phases_.at(k);
            value +=
                heights_.at(k) * (std::sin(static_cast<double>(k + 1) * angle + phase) - std::sin(phase));
        }
        return value / 2;
    }

  private:
    static constexpr std::size_t parts = 3;
    std::array<double, parts> heights_{}, phases_{};
};

/// A closed, smooth way of the tool in the incision: yaw, pitch, roll and insertion over an angle.
class PivotWay {
  public:
    PivotWay(const Placement& at, std::uint64_t seed)
        : incision_(upright_pose(at, at.entry + incision_height * at.normal)),
          yaw_(seed, 0),
          pitch_(seed, 1),
          roll_(seed, 2),
          dwell_(seed, 3) {}

    [[nodiscard]] Pose at(double angle) const {
        // In and out once a period, from 3 mm clear at angle 0; how deep within that is the seed's.
        const double in = (1 - std::cos(angle)) / 2 * (0.75 + 0.25 * dwell_.at(angle));
        return pivoted(incision_, {.yaw = swing * yaw_.at(angle),
                                   .pitch = swing * pitch_.at(angle),
                                   .roll = largest_roll * roll_.at(angle),
                                   .insertion = incision_height - clear + (clear + depth) * in});
    }

    /// Root mean square of |d tip / d angle| over a period, mm.
    [[nodiscard]] double tip_rate() const {
        constexpr int samples = 4096;
        const double step = 2 * std::numbers::pi / samples;
        double squares = 0;
        for (int k = 0; k < samples; ++k) {
            squares += (at((k + 1) * step).position - at(k * step).position).squaredNorm();
        }
        return std::sqrt(squares / samples) / step;
    }

  private:
    Pose incision_;
    Wave yaw_, pitch_, roll_, dwell_;
};

ScenePlan plan(const SceneInputs& inputs, const Placement& at) {
    const PivotWay way(at, inputs.seed);
    const double angle_a_step = inputs.speed * inputs.dt / way.tip_rate();
    ScenePlan plan{.start = way.at(0), .poses = {}, .insertion = {}};
    for (int k = 0; k < steps; ++k) plan.poses.push_back(way.at((at.phase + k) * angle_a_step));
    // Out along the shaft, so that the rest is one without a tool.
    const Pose& last = plan.poses.back();
    Walk out(last, inputs.speed, inputs.dt, 0);
    out.go_to(last.position + (depth + clear) * last.rotation.col(2));
    out.stay(rest_s);
    plan.poses.insert(plan.poses.end(), out.poses().begin(), out.poses().end());
    return plan;
}

}  // namespace

SceneEntry pivot() {
    return {.name = "pivot",
            .summary =
                "through an incision 100 mm above: 300 steps of smooth yaw, pitch, roll and insertion; "
                "the speed is the tip's root mean square",
            .place = [](const SceneInputs& inputs) { return place(inputs, {.depth = depth}); },
            .plan = plan};
}

}  // namespace trocar::scenes
