#pragma once

#include <optional>

#include "common/cycle/contact.h"
#include "experiments/metrics/judge/shifted_answers.h"
#include "strategies/strategy.h"

namespace trocar {

/// Asks a strategy once more what it answers to a step, with the rings of facets around the collided vertices
/// beginning elsewhere. Nothing of it feeds back into the step.
class RingShifts {
  public:
    /// The organ must outlive it. It is copied when a strategy is first asked.
    explicit RingShifts(const Organ& organ) : organ_(organ) {}

    /// The strategy's answers to `contact`, which is of this organ, in all shifts. They are missing where the
    /// strategy keeps state: it is not asked then; and where it throws or gives what check_response refuses.
    ShiftedAnswers ask(Strategy& strategy, const Description& description, const Contact& contact);

  private:
    const Organ& organ_;
    std::optional<Organ> shifted_;  // equal to it but for where rings begin; between questions in that too
};

}  // namespace trocar
