#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "results/record.h"

namespace trocar {

/// Version of the layout that README.md of this folder describes.
inline constexpr std::int64_t schema_version = 2;

/// A result file that cannot be read, written or merged. The message names the file and what to do.
struct StoreError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes a campaign of one case. The file appears under its final name only when it is whole: it is written
/// beside it, synced and renamed. Throws StoreError.
void write_case(const std::filesystem::path& file, const CampaignHeader& header, const CaseRecord& record);

/// What a result file holds, without its series and states.
struct Contents {
    CampaignHeader header;
    /// A row of /cases. What the file does not say is empty, or 0.
    struct Case {
        std::string case_id;
        std::string build_id;
        std::string status;
        bool has_series = false;
        bool has_replay = false;
        std::string metrics;            ///< the metrics that were on
        std::int64_t attempts = 0;      ///< how often the case was started, as far as results tell
        std::int64_t sweep_number = 0;  ///< of the case in the sweep's list, from 1
        std::string end;                ///< when the case ended, ISO 8601
        std::string machine;            ///< host and processor
    };
    std::vector<Case> cases;
};

/// Files are read in a child process (supervised.h): one that makes libhdf5 crash is damaged, no more. Throws
/// StoreError when `file` is no whole result file of this schema.
Contents read_contents(const std::filesystem::path& file);

/// The same of many files, at the price of one child.
std::vector<Contents> read_contents(std::span<const std::filesystem::path> files);

/// One file that a merge takes cases from: those of `case_ids`, or all.
struct Part {
    std::filesystem::path file;
    std::set<std::string> case_ids;
};

/// What of its parts a merged file holds.
enum class Merged {
    everything,
    tables,  ///< /cases, /states and /provenance, without any step's series and replays: a hundredth of the
             ///< size
};

/// Merges parts into one campaign file, atomically and in a child process as above, with the cases in the
/// order of `case_order` (every id in it must be in exactly one part); their rows of /states follow that
/// order too. Columns that a part lacks are filled with NaN, "" or 0. Refuses parts whose schema or sweep
/// differs, saying which. `out` may be one of the parts. Throws StoreError.
void merge(const std::filesystem::path& out, const CampaignHeader& header, std::span<const Part> parts,
           std::span<const std::string> case_order, Merged what = Merged::everything);

}  // namespace trocar
