#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/metrics/judge/judge.h"

namespace trocar {

inline Pose tip_at(double z) { return {.rotation = Mat3::Identity(), .position = {0, 0, z}}; }

inline const Metric& metric_named(const std::string& name) { return *choose_metrics(name).front(); }

/// An organ and a tool, of which tests make steps whose vertices are put somewhere by hand.
class JudgedSteps {
  public:
    using Positions = std::vector<Vec3>;

    JudgedSteps(Organ organ, Tool tool) : organ_(std::move(organ)), tool_(std::move(tool)) {}

    [[nodiscard]] const Organ& organ() const { return organ_; }
    [[nodiscard]] const Tool& tool() const { return tool_; }
    [[nodiscard]] const JudgedOrgan& judged_organ() const { return judged_organ_; }
    [[nodiscard]] const JudgedTool& judged_tool() const { return judged_tool_; }
    [[nodiscard]] const Positions& rest() const { return organ_.rest.positions; }
    [[nodiscard]] JudgedState state(const Positions& positions, const Pose& pose) const {
        return {judged_organ_, judged_tool_, positions, pose};
    }

    /// The region of the steps that follow; without it all vertices.
    void set_region(std::vector<Index> vertices) { region_ = region_of(judged_organ_, std::move(vertices)); }

    /// A step in which the tool stood still at `pose`.
    [[nodiscard]] Judged step(const Pose& pose, const Positions& before, const Positions& handled,
                              const Positions& deformed) const {
        Judged step(judged_organ_, judged_tool_, region_);
        step.tool_at_beginning = pose;
        step.before = state(before, pose);
        step.handled = state(handled, pose);
        step.deformed = state(deformed, pose);
        step.paths.emplace(*step.before);
        return step;
    }

  private:
    Organ organ_;
    Tool tool_;
    JudgedOrgan judged_organ_{organ_};
    JudgedTool judged_tool_{tool_};
    Region region_ = region_of(judged_organ_, all_vertices());

    [[nodiscard]] std::vector<Index> all_vertices() const {
        std::vector<Index> all(rest().size());
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<Index>(k);
        return all;
    }
};

/// The metric's value; NaN where it is missing.
inline double value(const std::string& metric, Moment moment, const Judged& step) {
    return metric_named(metric).value(step, moment).value;
}

inline Missing why_missing(const std::string& metric, Moment moment, const Judged& step) {
    return metric_named(metric).value(step, moment).missing;
}

}  // namespace trocar
