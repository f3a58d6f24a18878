#pragma once

#include <optional>

#include "common/tool/pose.h"

namespace trocar {

/// How the tool moved in one step, from the pose before to the pose after: rigid, rotation included.
class ToolMotion {
  public:
    ToolMotion(const Pose& before, const Pose& after);

    [[nodiscard]] const Pose& before() const { return before_; }
    [[nodiscard]] const Pose& after() const { return after_; }

    /// How far (mm), and which way, the tool's material that is now at `point` moved in this step.
    [[nodiscard]] Vec3 displacement_at(const Vec3& point) const {
        return translation_ + turn_ * (point - after_.position);
    }

    /// v_m of the paper's eq. (1): the unit direction of displacement_at. None where the material moved by
    /// less than `negligible` (mm), as in a tool held still or on the axis of a rotation.
    [[nodiscard]] std::optional<Vec3> direction_at(const Vec3& point, double negligible) const;

  private:
    Pose before_, after_;
    Vec3 translation_;  // of the tool frame's origin
    Mat3 turn_;         // I − R_before R_afterᵀ; exactly zero when the tool did not turn
};

}  // namespace trocar
