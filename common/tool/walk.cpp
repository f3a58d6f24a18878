#include "common/tool/walk.h"

#include <algorithm>
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

void Walk::go_along(std::span<const Pose> way) {
    std::vector<Pose> through{pose_};
    through.insert(through.end(), way.begin(), way.end());
    std::vector<double> gone_at{0};  // mm, at each of these poses
    for (std::size_t k = 1; k < through.size(); ++k) {
        gone_at.push_back(gone_at.back() + (through[k].position - through[k - 1].position).norm());
    }
    segment(gone_at.back(), [&](double part) {
        if (part == 1) return through.back();
        const double gone = part * gone_at.back();
        const auto next = std::ranges::upper_bound(gone_at, gone) - gone_at.begin();
        const double piece = gone_at[next] - gone_at[next - 1];
        return between(through[next - 1], through[next], (gone - gone_at[next - 1]) / piece);
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
