#pragma once

#include <span>
#include <vector>

#include "results/record.h"

namespace trocar {

/// The figures of a case: for each series its mean, maximum and final value over the window, named
/// `<series>_mean`, `<series>_max`, `<series>_final`. Steps whose value is NaN do not count; a figure without
/// any step is NaN. Columns are the same whatever the values are, so that the cases of a campaign make one
/// table.
/// @param window  per step, whether it counts; a series may be shorter (the case stopped early) or empty
std::vector<Cell> metric_figures(std::span<const Series> series, const std::vector<bool>& window);

/// The figures of timings: `<series>_p50`, `_p95`, `_p99` (nearest rank) and `_max` over the window. For
/// `time_cycle` also how many steps took longer than a budget: `time_cycle_over_33ms` (a frame at 30 Hz),
/// `_over_25ms` (at 40 Hz) and `_over_1ms` (haptics). NaN for an empty window.
std::vector<Cell> time_figures(std::span<const Series> series, const std::vector<bool>& window);

/// Turns every figure into NaN: a case that did not complete has none.
void clear_figures(std::span<Cell> figures);

}  // namespace trocar
