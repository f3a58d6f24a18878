#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace trocar {

/// A finished case and the file that holds it.
struct DoneCase {
    std::filesystem::path file;
    std::string build_id;
    std::string status;
    bool has_series = false;  ///< not where tables alone were merged
    bool has_replay = false;
    std::string metrics;  ///< those that were taken, as metric_names has them
    std::int64_t attempts = 0;
    std::string end;      ///< when it ended, ISO 8601; empty when the file does not say
    std::string machine;  ///< where it ran
};

/// Finished cases by their case_id.
using DoneCases = std::map<std::string, DoneCase>;

/// The folder beside `out` in which cases lie one by one until they are merged: "<out>.parts".
std::filesystem::path parts_folder_of(const std::filesystem::path& out);

/// Where the cases of a run with --fresh lie until the new result file is whole: "<out>.fresh.parts". Other
/// runs leave it alone.
std::filesystem::path fresh_parts_folder_of(const std::filesystem::path& out);

/// The cases of this sweep that lie in a parts folder, which need not exist. Throws InputError when one
/// cannot be read or is of another sweep.
DoneCases find_parts(const std::filesystem::path& folder, const std::string& sweep_hash);

/// What a run with --fresh that was cut off left in its folder. A case that `out` holds from the same run is
/// left out: that run came to publish its result, and only its folder was left behind. Throws as find_parts
/// does.
DoneCases find_fresh_parts(const std::filesystem::path& out, const std::string& sweep_hash);

/// What an earlier run of the same sweep left in `out` and in its parts folder; a part replaces the same case
/// of `out`. Changes nothing. Throws InputError when `out` exists and is no result file, and when `out` or a
/// part is of another sweep: neither may be written over.
DoneCases find_done_cases(const std::filesystem::path& out, const std::string& sweep_hash);

}  // namespace trocar
