#pragma once

#include "common/geometry/vector.h"

namespace trocar {

/// Where a rigid thing is, such as a tool: x_world = rotation · x_own + position.
struct Pose {
    Mat3 rotation = Mat3::Identity();
    Vec3 position = Vec3::Zero();  ///< of its own frame's origin (a tool's tip), mm

    [[nodiscard]] Vec3 to_world(const Vec3& in_tool) const { return rotation * in_tool + position; }
    [[nodiscard]] Vec3 direction_to_world(const Vec3& in_tool) const { return rotation * in_tool; }
    [[nodiscard]] Vec3 direction_to_tool(const Vec3& in_world) const {
        return rotation.transpose() * in_world;
    }

    /// The same place as seen from something that itself is at `frame`. An organ that moves counts as the
    /// tool moving the other way (the paper's footnote 1): a tool's poses in the frame of the organ are all
    /// that a scene needs of the two motions.
    [[nodiscard]] Pose seen_from(const Pose& frame) const {
        return {.rotation = frame.rotation.transpose() * rotation,
                .position = frame.rotation.transpose() * (position - frame.position)};
    }
};

/// After this part of the way from one pose to the other, from 0 to 1: the position goes straight, the
/// rotation turns evenly about one axis, the shorter way round.
Pose between(const Pose& from, const Pose& to, double part);

/// The coordinates, in the tool's frame, at which a point is judged. Every question whose answer must be
/// exact
/// ("is it inside?", "does this facet cross?") is asked of these rounded coordinates, by detection and by the
/// metrics alike: this function is the definition of both words.
Vec3 judged_position(const Pose& tool, const Vec3& world);

}  // namespace trocar
