#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "experiments/run/case_options.h"
#include "experiments/scenes/prepared_scene.h"
#include "experiments/sweep/cases.h"
#include "results/record.h"
#include "strategies/strategy.h"

namespace trocar {

/// Where the scene of a case comes from: prepared for it, or shared with other cases (see SharedScenes).
using SceneSource = std::function<std::shared_ptr<const PreparedScene>(const CaseInputs&)>;

/// Runs one case: runs the cycle over all poses of its scene under the judge's eyes, sums up. What goes wrong
/// in it is contained: an answer that is no answer, or a seed without a place, gives the status `failed`, an
/// organ that flies apart `diverged`, each with a reason; then the figures are NaN and the series hold the
/// steps before. The record's provenance and build_id are left to the caller.
/// What the options ask for besides (replay, same-state comparison) happens after the run or beside it.
/// @param strategy a fresh instance of the one that the inputs name
/// @returns nothing when `stop` was requested before the last step.
std::optional<CaseRecord> run_case(const CaseInputs& inputs, const SceneSource& scene_of, Strategy& strategy,
                                   const CaseOptions& options, const std::stop_token& stop);

/// The record of a case that ran where nothing could be gathered: its process did not live to the end.
/// @param wall_s how long it ran
CaseRecord lost_case(const CaseInputs& inputs, const CaseOptions& options, CaseStatus status,
                     const std::string& reason, double wall_s);

}  // namespace trocar
