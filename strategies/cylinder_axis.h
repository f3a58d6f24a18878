#pragma once

#include "strategies/registry.h"

namespace trocar {

/// How cylinder-axis moves one collided vertex.
struct AxisExit {
    Vec3 displacement;  ///< mm: orthogonally away from the tool's axis, to the exit from the tool
    bool on_axis;       ///< the vertex lies on the axis and went along a fixed direction of the tool
};
/// The exit of a collided vertex orthogonally away from the tool's axis.
AxisExit leave_axis(const Contact& contact, Index vertex);

/// The strategy `cylinder-axis`: [27] of the paper as its section III tells it.
StrategyEntry cylinder_axis_entry();

}  // namespace trocar
