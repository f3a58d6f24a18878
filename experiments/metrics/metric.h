#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/metrics/missing.h"

namespace trocar {

class Judged;

/// When in a step a metric is taken.
enum class Moment {
    before,    ///< as the step found the organ
    handled,   ///< H: after handling, before deformation
    deformed,  ///< D: after deformation
    end,       ///< once, after the last step
};

/// What taking it costs.
enum class Cost {
    low,   ///< little beside the step itself: taken by `--metrics fast` too
    high,  ///< looks at the tool's volume or surface, or at the organ's facets pair by pair, or has the
           ///< strategy asked again
};

/// One metric. Its function looks at one step.
struct Metric {
    std::string name;
    std::string units;       ///< "mm", "mm³"; "1" for counts and ratios
    std::string definition;  ///< one line
    std::string better;      ///< "low", "high" or "neither"
    std::vector<Moment> moments;
    Cost cost = Cost::low;
    bool of_paths = false;   ///< it reads Judged::paths: vertices are followed in every step, sampled or not
    bool of_shifts = false;  ///< it reads Judged::shifted: the strategy is asked again in sampled steps
    Measured (*value)(const Judged& step, Moment moment);
};

/// Every metric of this build, in the order in which they are listed and stored.
const std::vector<Metric>& all_metrics();

/// The metrics that a choice names, in the order of all_metrics(): "all", "fast" (all of low cost), or names
/// with commas between them. Throws std::invalid_argument for a name that no metric has, naming the nearest.
std::vector<const Metric*> choose_metrics(std::string_view choice);

/// The name of a metric's series: its own, with "_h" or "_d" where it is taken at both H and D.
std::string series_name(const Metric& metric, Moment moment);

}  // namespace trocar
