#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/sweep/cases.h"
#include "experiments/sweep/sweep.h"

namespace trocar {

/// A sweep that claims are judged on.
struct ClaimSweep {
    Sweep sweep;
    std::filesystem::path file;
    std::vector<const Metric*> metrics;  ///< that each of its cases is measured by
    std::vector<CaseInputs> cases;  ///< to be run now: what chosen claims need of it and no earlier sweep has
};

/// What `trocar reproduce` is asked for.
struct ClaimsWish {
    std::vector<std::string> chosen;  ///< ids of claims; none: all
    bool is_quick = false;            ///< fewer seeds of each sweep, as the file of claims says
    std::optional<std::filesystem::path>
        meshes;  ///< folder of the organs of the confirmation set; none: not run
};

/// What `trocar reproduce` runs, out of experiments/claims.toml and the sweeps that it names. What the
/// conditions are is left to the analysis, which judges them.
struct ClaimsPlan {
    std::vector<ClaimSweep> sweeps;  ///< in the order in which claims first name them, chosen claims or not
    std::vector<std::string> case_order;  ///< ids of all cases of all sweeps, asked for now or not
    std::vector<std::string> left_out;    ///< one line for each scene on an organ that has no place for it
    bool needs_turns = false;             ///< a chosen claim is judged on measure_turns
    std::string text;                     ///< of all sweeps: what identifies the campaign
};

/// Reads the claims and their sweeps. Throws InputError, naming file, line and column, for anything that is
/// wrong in one of the files, for a claim that there is not, and for a mesh that is missing.
ClaimsPlan plan_claims(const std::filesystem::path& file, const ClaimsWish& wish);

}  // namespace trocar
