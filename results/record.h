#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trocar {

/// How a case ended. Stored as this name.
enum class CaseStatus { complete, diverged, failed, timed_out, out_of_memory, crashed };

/// The name under which a status is stored: "complete", "diverged", …
std::string_view status_name(CaseStatus status);

/// A value of one row: text, a whole number or a figure. NaN stands for a figure that does not exist.
using Value = std::variant<std::string, std::int64_t, double>;

/// One column of /cases, /states or /provenance, as one row fills it.
struct Cell {
    std::string name;       ///< column, such as "strategy" or "depth_max_d_max"
    std::string units;      ///< "mm", "mm/s", "ns", "1" for numbers without unit, "" for text
    std::string long_name;  ///< what it is, for people
    Value value;
};

/// One value per step.
struct Series {
    std::string name;  ///< "<metric>" or "<metric>_<moment>"
    std::string units;
    std::string long_name;
    std::vector<double> values;
    /// Why values are NaN, as JSON: reason → ranges of steps, both ends included, such as
    /// {"no vertex collided": [[0, 4], [10, 12]]}. Empty when nothing is missing.
    std::string missing;
};

/// A point as it is stored for replays, mm.
using StoredPoint = std::array<float, 3>;

/// What a replay needs of one step.
struct ReplayStep {
    std::vector<StoredPoint> found;               ///< every organ vertex before handling
    std::vector<StoredPoint> handled;             ///< … after handling
    std::vector<StoredPoint> deformed;            ///< … after deformation
    std::array<float, 16> tool_pose{};            ///< 4×4 matrix, row by row: tool frame → world
    std::vector<std::int32_t> moved;              ///< vertices that the strategy displaced
    std::vector<std::array<double, 3>> moved_by;  ///< by how much, mm; as many as `moved`
};

/// Organ and tool through all steps of a case.
struct Replay {
    std::vector<std::array<std::int32_t, 3>> facets;
    std::vector<StoredPoint> rest_positions;
    std::vector<StoredPoint> tool_positions;  ///< in the tool's frame
    std::vector<std::array<std::int32_t, 3>> tool_facets;
    std::array<float, 16> tool_start{};  ///< pose before the first step, as in ReplayStep
    std::vector<ReplayStep> steps;
};

/// Everything one finished case leaves behind.
struct CaseRecord {
    std::string case_id;       ///< hash of the case's inputs
    std::string build_id;      ///< hash of the program
    std::vector<Cell> cells;   ///< of /cases, without case_id and build_id; in the order of the columns
    std::vector<double> time;  ///< end of each step, s
    std::vector<Series> series;
    /// The same-state comparison: rows of /states, without case_id, all with the same columns. None when it
    /// was not asked for.
    std::vector<std::vector<Cell>> states;
    std::optional<Replay> replay;
    std::vector<Cell> provenance;  ///< one row of /provenance
};

/// All cases of a sweep, in short.
struct CaseList {
    std::int64_t count;
    std::string ids_hash;  ///< of the ids in the sweep's order
    bool operator==(const CaseList&) const = default;
};

/// What identifies a campaign: attributes of the file's root.
struct CampaignHeader {
    std::string created_utc;  ///< ISO 8601
    std::string generator;    ///< program and version
    std::string sweep_toml;   ///< the sweep file's text
    std::string sweep_hash;
    std::optional<CaseList> sweep_cases = std::nullopt;  ///< files of earlier programs do not say
};

}  // namespace trocar
