#pragma once

#include "experiments/metrics/metric.h"

/// One function per metric, of the metric's name: those of metrics.inc.
namespace trocar::metrics {

#define TROCAR_METRIC(name) Metric name();
#include "experiments/metrics/metrics.inc"
#undef TROCAR_METRIC

}  // namespace trocar::metrics
