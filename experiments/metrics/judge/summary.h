#pragma once

#include <span>

#include "experiments/metrics/missing.h"

namespace trocar {

/// @{
/// Of some values; where there are none, missing for the reason `none`.
Measured mean_of(std::span<const double> values, Missing none);
Measured largest_of(std::span<const double> values, Missing none);
Measured least_of(std::span<const double> values, Missing none);
/// @}

}  // namespace trocar
