#include "experiments/scenes/walk.h"

#include <cmath>

namespace trocar {

Walk::Walk(const Pose& start, double speed, double dt, double phase)
    : pose_(start), full_step_(speed * dt), first_step_(phase * full_step_), dt_(dt) {}

void Walk::go_to(const Vec3& position) {
    const Vec3 from = pose_.position;
    const double length = (position - from).norm();
    // What is left of the way, if only by rounding, is not worth a step of its own.
    const double negligible = 1e-9 * full_step_;
    const double first = poses_.empty() ? first_step_ : full_step_;
    for (int k = 0;; ++k) {
        const double gone = first + k * full_step_;
        const bool arrives = gone >= length - negligible;
        pose_.position = arrives ? position : Vec3(from + (position - from) * (gone / length));
        poses_.push_back(pose_);
        if (arrives) return;
    }
}

void Walk::stay(double seconds) {
    const auto steps = static_cast<std::size_t>(std::lround(seconds / dt_));
    poses_.insert(poses_.end(), steps, pose_);
}

}  // namespace trocar
