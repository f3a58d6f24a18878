#pragma once

#include "experiments/metrics/examples/example.h"

/// One function per metric, of the metric's name.
namespace trocar::examples {

/// @{
/// A step of which the metric's value is known by construction. A new example is a file, a line here and a
/// line in example.cpp.
Example collided_vertices();
Example vertices_inside();
Example depth_max();
Example depth_mean();
Example facets_crossing();
Example tool_points_inside();
Example tool_volume_inside();
Example tunnelled();
Example tool_crossings();
Example displacement_crossings();
Example flipped_facets();
Example self_crossings();
Example spread();
Example edge_ratio_mean();
Example edge_ratio_min();
Example displacement_mean();
Example displacement_max();
Example gap_mean();
Example gap_max();
Example drag();
Example strain();
Example jitter();
Example recovery();
Example volume_change();
Example fallbacks();
/// @}

}  // namespace trocar::examples
