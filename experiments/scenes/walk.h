#pragma once

#include <vector>

#include "common/tool/pose.h"

namespace trocar {

/// A tool's way through a scene at constant speed: straight segments and pauses, one pose per step.
class Walk {
  public:
    /// @param speed mm/s, positive
    /// @param dt length of a step, s
    /// @param phase in [0, 1): the length of the very first step, as a part of a full one
    Walk(const Pose& start, double speed, double dt, double phase);

    /// Straight to `position`, without turning; the last step is shorter, so that it ends exactly there.
    void go_to(const Vec3& position);

    /// Stays for `seconds`, rounded to whole steps.
    void stay(double seconds);

    /// The pose at the end of each step so far.
    [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }

  private:
    Pose pose_;
    double full_step_;   // mm
    double first_step_;  // mm
    double dt_;
    std::vector<Pose> poses_;
};

}  // namespace trocar
