#pragma once

#include <span>
#include <vector>

#include "common/tool/pose.h"

namespace trocar {

/// A tool's way at constant speed: straight segments, ways through many poses, turns about its tip and
/// pauses, one pose per step. The first step is a part of a full one; each segment ends exactly where it
/// says, with a shorter step, so that what is reached does not depend on the speed.
class Walk {
  public:
    /// @param speed mm/s, positive
    /// @param dt length of a step, s
    /// @param phase in [0, 1): the length of the very first step, as a part of a full one
    Walk(const Pose& start, double speed, double dt, double phase);

    /// Straight to `position`, without turning.
    void go_to(const Vec3& position);

    /// Through these poses, which are one segment: none but the last need be the end of a step, however close
    /// they are. Between two of them the tip goes straight and the tool turns evenly over that way, which
    /// must not be of length 0: a tool whose tip stays would turn in no time. None: a step that stays.
    void go_along(std::span<const Pose> way);

    /// Turns about the line through the tip along the unit vector `axis` (world), counter-clockwise by
    /// `angle` (rad, positive), as fast as a point at `radius` (mm) from that line moves at the walk's speed.
    void turn(const Vec3& axis, double angle, double radius);

    /// Stays for `seconds`, rounded to whole steps.
    void stay(double seconds);

    /// The pose at the end of each step so far.
    [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }

  private:
    template <typename PoseAt>
    void segment(double length, const PoseAt& pose_at);

    Pose pose_;
    double full_step_;   // mm
    double first_step_;  // mm
    double dt_;
    std::vector<Pose> poses_;
};

}  // namespace trocar
