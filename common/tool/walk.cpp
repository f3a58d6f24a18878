#include "common/tool/walk.h"

#include <cmath>

#include <Eigen/Geometry>

namespace trocar {

Walk::Walk(const Pose& start, double speed, double dt, double phase)
    : pose_(start), full_step_(speed * dt), first_step_(phase * full_step_), dt_(dt) {}

/// Appends the poses of a segment `length` mm long; `pose_at(part)` is the pose after that part of it, from 0
/// to 1, and exact at 1.
template <typename PoseAt>
void Walk::segment(double length, const PoseAt& pose_at) {
    // What is left of the way, if only by rounding, is not worth a step of its own.
    const double negligible = 1e-9 * full_step_;
    const double first = poses_.empty() ? first_step_ : full_step_;
    for (int k = 0;; ++k) {
        const double gone = first + k * full_step_;
        const bool arrives = gone >= length - negligible;
        poses_.push_back(pose_at(arrives ? 1 : gone / length));
        if (arrives) break;
    }
    pose_ = poses_.back();
}

void Walk::go_to(const Vec3& position) {
    const Pose from = pose_;
    segment((position - from.position).norm(), [&](double part) {
        Pose pose = from;
        pose.position = part == 1 ? position : Vec3(from.position + part * (position - from.position));
        return pose;
    });
}

void Walk::turn(const Vec3& axis, double angle, double radius) {
    const Pose from = pose_;
    segment(angle * radius, [&](double part) {
        Pose pose = from;
        pose.rotation = Eigen::AngleAxisd(part * angle, axis).toRotationMatrix() * from.rotation;
        return pose;
    });
}

void Walk::stay(double seconds) {
    const auto steps = static_cast<std::size_t>(std::lround(seconds / dt_));
    poses_.insert(poses_.end(), steps, pose_);
}

}  // namespace trocar
