#pragma once

#include "experiments/metrics/metric.h"

/// One function per metric.
namespace trocar::metrics {

/// @{
/// Each is defined in the file of its name, or of what it shares with another (depth_max and depth_mean in
/// depth.cpp). A new metric is a file, a line here and a line in metric.cpp.
Metric collided_vertices();
Metric vertices_inside();
Metric depth_max();
Metric depth_mean();
Metric facets_crossing();
Metric tool_points_inside();
Metric tool_volume_inside();
Metric tunnelled();
Metric tool_crossings();
Metric displacement_crossings();
Metric flipped_facets();
Metric self_crossings();
Metric spread();
Metric edge_ratio_mean();
Metric edge_ratio_min();
Metric displacement_mean();
Metric displacement_max();
Metric gap_mean();
Metric gap_max();
Metric drag();
Metric strain();
Metric jitter();
Metric recovery();
Metric volume_change();
Metric fallbacks();
/// @}

}  // namespace trocar::metrics
