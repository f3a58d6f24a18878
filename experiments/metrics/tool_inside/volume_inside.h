#pragma once

#include "experiments/metrics/judge/judged_state.h"

namespace trocar {

/// The volume (mm³) of the part of the tool where the organ's winding number is at least 1. The organ must
/// have an inside (JudgedOrgan::has_inside). Right but for rounding where the organ's surface does not cross
/// itself within the tool; else right to 1 % or 0.1 mm³.
double volume_inside(const JudgedState& state);

}  // namespace trocar
