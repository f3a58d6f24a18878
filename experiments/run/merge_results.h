#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/store.h"

namespace trocar {

/// What came of merging result files.
struct MergeOutcome {
    std::size_t files = 0;                         ///< that were read
    std::size_t cases = 0;                         ///< in the merged file
    std::map<std::string, std::size_t> by_status;  ///< of these
    std::size_t left_out = 0;                      ///< cases of the inputs that another input has newer
    std::optional<std::size_t> sweep_cases;        ///< of the whole sweep, where a file says it
    bool in_order = true;               ///< false where a file does not say what the sweep's order is
    std::vector<std::string> warnings;  ///< of mixed_origins
    std::filesystem::path xdmf;         ///< opens the replays in ParaView; empty where there are none
};

/// Merges result files of one sweep into `out`, in the sweep's order. Inputs are result files, and folders of
/// which every file *.h5 is one, such as the parts that a run left. Of a case that is in several of them a
/// complete one is taken before one that is not; of one build the one that has more metrics, series or a
/// replay; else the one that ended last, of equal times the one named last. `out` appears when it is whole;
/// one that is there is replaced if the inputs hold all of its cases. Throws InputError when an input is no
/// result file, of another schema or sweep, or when `out` would lose something or is being written;
/// StoreError when writing fails.
MergeOutcome merge_results(std::span<const std::filesystem::path> inputs, const std::filesystem::path& out,
                           Merged what = Merged::everything);

}  // namespace trocar
