#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/store.h"

namespace trocar {

/// A line for people when cases that lie in one file come from several programs, and one when they come from
/// several machines: their times cannot be compared. Empty otherwise.
std::vector<std::string> mixed_origins(std::span<const Contents::Case> cases);

}  // namespace trocar
