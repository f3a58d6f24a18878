#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "experiments/run/case_options.h"
#include "experiments/run/workers/supervise.h"
#include "experiments/sweep/cases.h"
#include "results/record.h"
#include "strategies/registry.h"

namespace trocar {

/// What run_sweep is asked for.
struct RunRequest {
    std::filesystem::path out;  ///< result file
    CampaignHeader header;
    std::vector<std::string> case_order;  ///< ids of all cases of the sweep
    std::vector<CaseInputs> cases;        ///< those of them that are asked for
    unsigned jobs = 1;                    ///< cases that run at once, each in a process of its own
    TaskLimits limits;                    ///< of one case
    bool timing =
        false;  ///< one case at a time on one core, in an order that spreads drift over all strategies
    CaseOptions options;
    std::string build_id;       ///< results of another build are run again
    bool retry_failed = false;  ///< and those that are not complete
    /// Everything is run again. The result file stays as it is until every case is done; until then they lie
    /// in a folder of their own, where the next fresh run goes on. Once the result file has them, the next
    /// fresh run starts over, even if this one was killed before it could remove the folder.
    bool fresh = false;
    std::vector<std::string> arguments;  ///< the command line, for the provenance
};

/// How a sweep ended.
struct RunOutcome {
    std::map<std::string, std::size_t> by_status;  ///< of the cases asked for that are in the result file
    std::vector<std::string> failures;  ///< one line for each case that ran now and did not complete
    std::size_t kept = 0;               ///< cases that an earlier run had finished
    std::size_t ran = 0;                ///< cases finished now
    bool interrupted = false;           ///< `stop` was requested; unfinished cases are in no file
    bool merged = true;                 ///< false after a fresh run that was interrupted
    std::filesystem::path xdmf;         ///< opens the replays in ParaView; empty where there are none
};

/// The cases asked for that no earlier run of this build has finished. Throws InputError (see
/// find_done_cases).
std::vector<CaseInputs> pending_cases(const RunRequest& request);

/// Runs the pending cases in child processes, `jobs` at once. A case that ends its process, or takes more
/// than its limits, is stored with that outcome, and the others go on. Each finished case is written at once
/// as a file of its own; at the end, and when `stop` is requested, all are merged into `out`, in the sweep's
/// order, whatever the order they finished in. `on_progress` is called after each case with the number of
/// cases done and of all that were pending. Throws InputError, before anything runs, when `out` cannot be
/// written or holds something else, and StoreError when writing fails: finished cases then stay in the parts
/// folder, where the next run finds them.
RunOutcome run_sweep(const RunRequest& request,
                     const std::function<void(std::size_t, std::size_t)>& on_progress,
                     const std::stop_token& stop);

}  // namespace trocar
