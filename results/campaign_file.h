#pragma once

#include <filesystem>
#include <string>

#include "results/hdf5_handles.h"
#include "results/store.h"
#include "results/table.h"

// The root of a result file: its attributes and groups. README.md shows the layout.
namespace trocar {

/// @{
/// Names of the groups.
inline constexpr auto cases_group = "cases";
inline constexpr auto series_group = "series";
inline constexpr auto replay_group = "replay";
inline constexpr auto states_group = "states";
inline constexpr auto provenance_group = "provenance";
/// @}

/// A result file that is whole and of this schema, open for reading.
struct CampaignFile {
    hdf5::File file;
    CampaignHeader header;
};

/// To be called within `supervised`. Throws StoreError when `path` is anything else.
CampaignFile open_campaign(const std::filesystem::path& path);

/// A result file without cases. The groups are there and empty.
hdf5::File create_campaign(const std::filesystem::path& path, const CampaignHeader& header);

/// Writes the three tables. Row i of `provenance` tells how the cases with `provenance_row` i were run. The
/// rows of `states`, which has the column case_id, are numbered here; without rows its group stays empty.
void write_tables(const hdf5::File& file, const Table& cases, Table states, const Table& provenance);

/// Marks the file as whole and closes it. Throws StoreError when something did not reach the file.
void finish_campaign(hdf5::File file, const std::filesystem::path& path);

/// @{
/// Columns that the store itself adds.
Column case_id_column(Texts ids);
Column run_id_column(Texts ids);
Column build_id_column(Texts ids);
Column provenance_row_column(WholeNumbers rows);
Column covered_cases_column(WholeNumbers counts);
/// @}

}  // namespace trocar
