#pragma once

#include "common/cycle/cycle.h"
#include "results/record.h"

namespace trocar {

/// A replay of this organ and tool, without steps; where the tool starts is not known.
Replay empty_replay(const Organ& organ, const Tool& tool);

/// Where the tool is before the first step.
void record_start(Replay& replay, const Pose& start);

/// @{
/// One step is recorded in three calls, each after the phase that it is named after.
void record_detected(Replay& replay, const Cycle& cycle);
void record_handled(Replay& replay, const Cycle& cycle);
void record_deformed(Replay& replay, const Cycle& cycle);
/// @}

}  // namespace trocar
