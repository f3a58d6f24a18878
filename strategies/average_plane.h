#pragma once

#include "strategies/registry.h"

namespace trocar {

/// The strategy `average-plane`: [30] of the paper as its section III tells it.
StrategyEntry average_plane_entry();

}  // namespace trocar
