#pragma once

#include "common/geometry/vector.h"
#include "common/tool/pose.h"

namespace trocar {

/// The rotation that a still thing makes, seen from a tool that moves.
struct Turn {
    Vec3 axis = Vec3::UnitX();  ///< unit, in the tool's frame
    double angle = 0;           ///< rad, 0 to π

    /// Of a tool that goes from one pose to the other.
    static Turn seen_from(const Pose& from, const Pose& to);
};

/// The way of a still point seen from a tool that moves by a screw: a rotation at constant speed about a
/// fixed axis and a translation along it, both at once. Any two poses have one screw between them (Chasles)
/// that turns by less than π; a tool that turns about a fixed point, or goes straight, moves by its screw.
///
/// With ω the turn's vector, p(t) = p₀ + t V(tω) w, where V(φ) = I + (1 − cos φ)/φ [a]× + (1 − sin φ/φ) [a]×²
/// and w = V(ω)⁻¹ (p₁ − p₀) is the velocity at p₀: the exponential map of rigid motions.
class Arc {
  public:
    /// From one point to the other (in the tool's frame, mm), both of them the same point of the world.
    Arc(const Vec3& from, const Vec3& to, const Turn& turn);

    /// Where the point is after this part of the way; at 0 and at 1 exactly `from` and `to`.
    [[nodiscard]] Vec3 at(double part) const;

    /// No point of the arc is further from the same part of the straight way than this, mm: |p″| / 8, and the
    /// acceleration |p″| = |ω × w| is the same everywhere on a screw's helix.
    [[nodiscard]] double bulge() const { return bulge_; }

    /// So many equal parts of the arc have chords none of which is further from it than `error` (mm).
    [[nodiscard]] int chords(double error) const;

  private:
    Vec3 from_, to_;
    Turn turn_;
    Vec3 velocity_;
    double bulge_;
};

}  // namespace trocar
