#pragma once

#include <stdexcept>
#include <string_view>
#include <vector>

#include "common/tool/pose.h"

namespace trocar {

/// A motion as it was recorded: poses at ascending times.
struct RecordedMotion {
    std::vector<double> times;  ///< s
    std::vector<Pose> poses;    ///< one for each time

    [[nodiscard]] double duration() const { return times.back() - times.front(); }

    /// The pose `since_start` seconds after the first one: positions are interpolated linearly, orientations
    /// along the shortest turn; the last pose from the end on.
    [[nodiscard]] Pose at(double since_start) const;

    /// Root mean square of the tip's speed over the whole motion, mm/s.
    [[nodiscard]] double tip_speed() const;
};

/// Something is wrong with a recorded motion; the message starts with the line and column where there is one.
struct MotionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads comma-separated text: a first line that names the columns t, x, y, z, qw, qx, qy, qz in this order,
/// then one pose per line: time in s, the tip in mm, the orientation as a unit quaternion. Empty lines and
/// lines that start with # are skipped. Throws MotionError for anything else, for less than two poses, times
/// that do not ascend, and a quaternion whose length is not 1 to within 0.001.
RecordedMotion parse_recorded_motion(std::string_view text);

}  // namespace trocar
