#pragma once

#include <optional>

#include "strategies/negligible.h"

namespace trocar {

/// v_m of the paper's eq. (1) at a point: the unit direction in which the tool's material there moved in this
/// step. None where it moved by a negligible length: a tool held still, or a point on the axis of its turn.
inline std::optional<Vec3> motion_vector(const Contact& contact, const Vec3& point) {
    return contact.motion.direction_at(point, negligible_length(contact));
}

}  // namespace trocar
