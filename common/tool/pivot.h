#pragma once

#include "common/tool/pose.h"

namespace trocar {

/// How a laparoscopic tool sits in an incision, which leaves it four degrees of freedom.
struct PivotState {
    double yaw = 0, pitch = 0;  ///< of the shaft about the incision, rad
    double roll = 0;            ///< of the tool about its own axis, rad
    double insertion = 0;       ///< from the incision to the tip, mm
};

/// The pose of a tool whose axis passes through an incision. `incision` is a frame at the incision; in it the
/// tool without yaw and pitch points along −z, its axis (from tip to handle) along +z.
Pose pivoted(const Pose& incision, const PivotState& state);

}  // namespace trocar
