#pragma once

#include <optional>
#include <stop_token>

#include "experiments/sweep/cases.h"
#include "results/record.h"
#include "strategies/strategy.h"

namespace trocar {

/// Runs one case: lays out the scene, runs the cycle over all its poses under the judge's eyes, sums up. What
/// goes wrong in it is contained: an answer that is no answer, or a seed without a place, gives the status
/// `failed`, an organ that flies apart `diverged`, each with a reason; then the figures are NaN and the
/// series hold the steps before. The record's provenance and build_id are left to the caller.
/// @returns nothing when `stop` was requested before the last step.
std::optional<CaseRecord> run_case(const CaseInputs& inputs, bool with_replay, const std::stop_token& stop);

/// The same with a given strategy instead of the one that the inputs name.
std::optional<CaseRecord> run_case(const CaseInputs& inputs, Strategy& strategy, bool with_replay,
                                   const std::stop_token& stop);

}  // namespace trocar
