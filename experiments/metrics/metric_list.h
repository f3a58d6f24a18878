#pragma once

#include "experiments/metrics/metric.h"

/// One function per metric.
namespace trocar::metrics {

/// @{
/// Each is defined in the file of its name. A new metric is a file, a line here and a line in metric.cpp.
Metric collided_vertices();
Metric vertices_inside();
Metric depth_max();
Metric depth_mean();
Metric facets_crossing();
Metric tunnelled();
Metric tool_crossings();
Metric displacement_mean();
Metric displacement_max();
Metric flipped_facets();
Metric fallbacks();
/// @}

}  // namespace trocar::metrics
