#include "experiments/metrics/tool_inside/volume_inside.h"

#include "experiments/metrics/tool_inside/organ_over_tool.h"

namespace trocar {

double volume_inside(const JudgedState& state) {
    constexpr double rounding = 1e-12;  // of the tool's box
    const std::vector<Corners> organ = organ_over_tool(state);
    // Where the organ's surface crosses itself the rays correct what its winding number counts too much;
    // where there is more to correct than there is inside, they alone do better.
    const SeenVolumes seen = state.tool().rays().look(organ);
    if (seen.ambiguous > seen.inside) return seen.inside;
    const double volume = state.tool().winding_integral().over_tool(organ) - seen.excess;
    return volume > rounding * state.tool().box().size().prod() ? volume : 0;
}

}  // namespace trocar
