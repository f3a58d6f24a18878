#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/sweep/cases.h"
#include "experiments/sweep/sweep.h"

namespace trocar {

/// A sweep that claims are judged on.
struct ClaimSweep {
    Sweep sweep;
    std::filesystem::path file;
    std::vector<CaseInputs> cases;  ///< its cases that no sweep before it has
};

/// What `trocar reproduce` runs, out of experiments/claims.toml and the sweeps that it names. What the
/// conditions are is left to the analysis, which judges them.
struct ClaimsPlan {
    std::vector<ClaimSweep> sweeps;  ///< in the order in which claims first name them, chosen claims or not
    std::vector<bool> needed;        ///< of each sweep: a chosen claim is judged on it
    std::vector<std::string> left_out;  ///< one line for each scene on an organ that has no place for it
    bool needs_turns = false;           ///< a chosen claim is judged on measure_turns
    std::string metrics;                ///< as --metrics takes them
    std::uint64_t quick_seeds = 0;      ///< seeds of each sweep that a quick run takes
    std::string text;                   ///< of all sweeps: what identifies the campaign
};

/// Reads the claims and their sweeps.
/// @param chosen  ids of claims; none: all
/// @param meshes  the folder with the organs of the confirmation set; none: they are not run
/// Throws InputError, naming file, line and column, for anything that is wrong in one of the files, for a
/// claim that there is not, and for a mesh that is missing.
ClaimsPlan plan_claims(const std::filesystem::path& file, std::span<const std::string> chosen,
                       const std::optional<std::filesystem::path>& meshes);

}  // namespace trocar
