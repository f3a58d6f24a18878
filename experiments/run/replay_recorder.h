#pragma once

#include "common/cycle/cycle.h"
#include "results/record.h"

namespace trocar {

/// A replay of this organ and tool, without steps.
Replay empty_replay(const Organ& organ, const Tool& tool);

/// @{
/// One step is recorded in three calls, each after the phase that it is named after.
void record_detected(Replay& replay, const Cycle& cycle);
void record_handled(Replay& replay, const Cycle& cycle);
void record_deformed(Replay& replay, const Cycle& cycle);
/// @}

}  // namespace trocar
