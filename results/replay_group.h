#pragma once

#include <string>

#include "results/hdf5_handles.h"
#include "results/record.h"

namespace trocar {

/// Writes `/replay/<case_id>`, `group` being /replay.
void write_replay(hid_t group, const std::string& case_id, const Replay& replay);

}  // namespace trocar
