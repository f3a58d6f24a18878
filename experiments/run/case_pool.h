#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "experiments/sweep/cases.h"

namespace trocar {

/// Calls `run` for each case, `jobs` at once, in the order of `cases`; each call gets a token that asks it to
/// stop. Once `stop` is requested or a call throws, no further case is started. Returns when all calls have
/// returned, and throws what the first of them threw.
void for_each_case(std::span<const CaseInputs> cases, unsigned jobs, const std::stop_token& stop,
                   const std::function<void(const CaseInputs&, const std::stop_token&)>& run);

}  // namespace trocar
