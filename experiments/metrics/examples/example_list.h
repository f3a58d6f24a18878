#pragma once

#include "experiments/metrics/examples/example.h"

/// One function per metric, of the metric's name: a step of which the metric's value is known by
/// construction.
namespace trocar::examples {

#define TROCAR_METRIC(name) Example name();
#include "experiments/metrics/metrics.inc"
#undef TROCAR_METRIC

}  // namespace trocar::examples
