#pragma once

#include <vector>

#include "experiments/metrics/judge/judged_state.h"

namespace trocar {

/// The organ's facets of which some part lies straight above some part of the tool's box, seen along the
/// tool's axis (+z in its frame): all that count for winding numbers within the tool, and few others. A sheet
/// is closed by a cone from its border to a point far beneath its middle. In the tool's frame.
std::vector<Corners> organ_over_tool(const JudgedState& state);

}  // namespace trocar
