#pragma once

#include "strategies/registry.h"

namespace trocar {

/// The strategy `joint-vertex`: the fuzzy inference once for all collided vertices (the paper's preliminary
/// work, section IV and Fig. 4).
StrategyEntry joint_vertex_entry();

}  // namespace trocar
