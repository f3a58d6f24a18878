#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/record.h"

namespace trocar {

/// Now, as ISO 8601 in UTC: "2009-11-05T12:00:00.125Z".
std::string now_utc();

/// The model of this machine's processor; "unknown" where /proc/cpuinfo does not say it.
std::string cpu_model();

/// The case's row of /provenance: the program, how it was built, the machine and its load, the command line.
/// `start` and `end` are the times between which the case ran. Rows name their case, so that a store that
/// keeps equal rows once numbers them the same way in every run.
/// @param arguments  the command line
std::vector<Cell> provenance_row(const std::string& case_id, std::span<const std::string> arguments,
                                 const std::string& start, const std::string& end);

}  // namespace trocar
