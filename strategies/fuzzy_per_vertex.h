#pragma once

#include "strategies/registry.h"

namespace trocar {

/// The strategy `fuzzy-per-vertex`: the paper's proposed method (section IV, eqs. 1 and 2).
StrategyEntry fuzzy_per_vertex_entry();

}  // namespace trocar
