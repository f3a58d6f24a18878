#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "experiments/run/workers/worker.h"
#include "experiments/sweep/cases.h"

namespace trocar {

/// Cases of one scene after each other, the scenes in the order of their first case: a scene is prepared
/// once, and a run that is cut off leaves comparisons that are whole.
std::vector<CaseInputs> by_scene(std::vector<CaseInputs> cases);

/// For timing: the scenes in an order that has nothing to do with what they are, and within a scene the
/// strategies likewise, so that a machine that grows slower does so for all of them alike. The order is the
/// same whenever `seed` is.
std::vector<CaseInputs> spread_out(std::vector<CaseInputs> cases, const std::string& seed);

/// The cases, which are ordered by scene, cut into what one worker does at a time: a scene, or a part of it
/// where there are too few scenes to keep all workers busy.
std::deque<Batch> batches_of(std::span<const CaseInputs> cases, unsigned workers);

/// Keeps this process on the last of the cores that it may use.
void stay_on_one_core();

}  // namespace trocar
