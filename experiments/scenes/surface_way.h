#pragma once

#include <optional>
#include <vector>

#include "experiments/scenes/scene.h"

namespace trocar {

/// The way of `length` (mm) along the surface of the organ at rest that starts at `start`, upright on it, in
/// the direction of its x axis: a pose every millimetre or so, and at the end. Each stands upright on the
/// surface: its position is a point of it, its z axis the mean outer normal there within two tool radii, and
/// its x axis points along the way. From one to the next the tool turns by the smallest rotation from normal
/// to normal, so the way is as straight as the surface lets it be.
///
/// None where the surface cannot be followed so: where a step leads less than half a millimetre further (the
/// surface ends there, or falls away steeply), or turns the normal by more than 30 degrees (over a sharp rim,
/// or from one wall to another).
std::optional<std::vector<Pose>> surface_way(const SceneInputs& inputs, const Pose& start, double length);

}  // namespace trocar
