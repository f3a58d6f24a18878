#include "experiments/metrics/paths/arc.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace trocar {
namespace {

constexpr double tiny_angle = 1e-8;  // rad: below it the series ends after its first term

/// (1 − cos φ) / φ and 1 − sin φ / φ, of V.
double sideways(double angle) {
    const double half = angle / 2;
    return angle < tiny_angle ? half : std::sin(half) * std::sin(half) / half;
}
double inwards(double angle) { return angle < tiny_angle ? 0 : 1 - std::sin(angle) / angle; }

/// V⁻¹ (p₁ − p₀), with V⁻¹ = I − φ/2 [a]× + (1 − φ/2 cot φ/2) [a]×².
Vec3 starting_velocity(const Vec3& way, const Turn& turn) {
    const double half = turn.angle / 2;
    const double inwards = turn.angle < tiny_angle ? 0 : 1 - half * std::cos(half) / std::sin(half);
    const Vec3 across = turn.axis.cross(way);
    return way - half * across + inwards * turn.axis.cross(across);
}

}  // namespace

Turn Turn::seen_from(const Pose& from, const Pose& to) {
    const Mat3 relative = to.rotation.transpose() * from.rotation;
    const Eigen::AngleAxisd turn{Eigen::Quaterniond(relative)};
    return {.axis = turn.axis(), .angle = turn.angle()};
}

Arc::Arc(const Vec3& from, const Vec3& to, const Turn& turn)
    : from_(from),
      to_(to),
      turn_(turn),
      velocity_(starting_velocity(to - from, turn)),
      bulge_(turn.angle * turn.axis.cross(velocity_).norm() / 8) {}

Vec3 Arc::at(double part) const {
    if (part >= 1) return to_;
    const double angle = part * turn_.angle;
    const Vec3 across = turn_.axis.cross(velocity_);
    return from_ + part * (velocity_ + sideways(angle) * across + inwards(angle) * turn_.axis.cross(across));
}

int Arc::chords(double error) const {
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(bulge_ / error))));
}

}  // namespace trocar
