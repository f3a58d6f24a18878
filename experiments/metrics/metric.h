#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/cycle/cycle.h"

namespace trocar {

class Judged;

/// When in a step a metric is taken.
enum class Moment {
    before,    ///< as the step found the organ
    handled,   ///< H: after handling, before deformation
    deformed,  ///< D: after deformation
};

/// One metric. Its function looks at one step and answers NaN where the value does not exist.
struct Metric {
    std::string name;
    std::string units;       ///< "mm", "ns"; "1" for counts
    std::string definition;  ///< one line
    std::string better;      ///< "low", "high" or "neither"
    std::vector<Moment> moments;
    double (*value)(const Judged& step, Moment moment);
};

/// Every metric of this build, in the order in which they are listed and stored.
const std::vector<Metric>& all_metrics();

/// The name of a metric's series: its own, with "_h" or "_d" where it is taken at both H and D.
std::string series_name(const Metric& metric, Moment moment);

/// Takes all metrics of one case, step by step. It shares no code with strategies or detection: it has its
/// own trees over the tool and looks at every organ vertex near it.
class Judge {
  public:
    Judge(const Organ& organ, const Tool& tool);
    ~Judge();
    Judge(const Judge&) = delete;
    Judge& operator=(const Judge&) = delete;

    /// To be called in this order in every step: after detection, after handling, after deformation.
    void before(const Cycle& cycle);
    void handled(const Cycle& cycle);
    void deformed(const Cycle& cycle);

    /// The step's values, one for each of all_metrics()' moments, metric by metric.
    [[nodiscard]] std::vector<double> values() const;

  private:
    struct Case;
    std::unique_ptr<Case> case_;
};

}  // namespace trocar
