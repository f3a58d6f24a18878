#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/cycle/cycle.h"
#include "experiments/metrics/judge/judge.h"
#include "experiments/run/case_options.h"
#include "results/record.h"

namespace trocar {

/// A step of a run as its strategy found it, and what that strategy answered.
struct FoundState {
    std::size_t step;
    Judged judged;  ///< before and at H
    std::vector<Vec3> velocities;
    ToolMotion motion;
    Detected detected;
};

/// Keeps some of a run's steps: of all that it is offered each is as likely as any other to be kept (Vitter's
/// reservoir, "Random sampling with a reservoir", 1985, algorithm R). Which ones depends on the case_id
/// alone.
class StateSampler {
  public:
    StateSampler(const std::string& case_id, int states);

    /// To be called after handling, of steps in the window at which vertices collided.
    void offer(std::size_t step, const Cycle& cycle, const Judged& judged);

    /// In the order of their steps.
    [[nodiscard]] std::vector<FoundState> kept() &&;

  private:
    std::uint64_t seed_;
    std::size_t most_;
    std::uint64_t offered_ = 0;
    std::vector<std::unique_ptr<FoundState>> kept_;
};

/// The same-state comparison: every strategy's answer to these states, judged at H. One row each: the step,
/// the strategy that answered, the metrics of before and H, and why they are missing where it gave no answer
/// that is one. A strategy answers as one that was never asked before; the run's own answer is what it
/// answered then. Nothing of it feeds back.
/// @param own label of the strategy whose run it was
std::vector<std::vector<Cell>> compare_on(const std::vector<FoundState>& states, const CaseOptions& options,
                                          const std::string& own, const CycleSettings& cycle);

}  // namespace trocar
