#include "results/campaign_file.h"

#include <numeric>

#include <fmt/format.h>

#include "results/supervised.h"

namespace trocar {
namespace {

/// Compact indices: most datasets here are one chunk, and the default spends 2 KB on the index of each.
constexpr unsigned chunk_index_half_width = 4;

hdf5::PropertyList property_list(hid_t kind, const std::filesystem::path& path) {
    const hid_t list = H5Pcreate(kind);
    if (list < 0) hdf5::fail(path, "cannot prepare the file");
    return hdf5::PropertyList(list);
}

void check_schema(hid_t file, const std::filesystem::path& path) {
    if (H5Aexists(file, "schema_version") <= 0) {
        throw StoreError(
            fmt::format("{}: is an HDF5 file but no Trocar result file: it has no attribute "
                        "schema_version",
                        path.string()));
    }
    const std::int64_t version = hdf5::read_number_attribute(file, "schema_version");
    if (version != schema_version) {
        throw StoreError(
            fmt::format("{}: has schema version {}, this program reads version {}; use the program "
                        "that wrote it, or run its sweep again",
                        path.string(), version, schema_version));
    }
    if (H5Aexists(file, "complete") <= 0 || hdf5::read_number_attribute(file, "complete") != 1) {
        throw StoreError(
            fmt::format("{}: is not whole: whoever wrote it did not finish; remove it and run its "
                        "sweep again",
                        path.string()));
    }
}

CampaignHeader read_header(hid_t file) {
    CampaignHeader header{.created_utc = hdf5::read_text_attribute(file, "created_utc"),
                          .generator = hdf5::read_text_attribute(file, "generator"),
                          .sweep_toml = hdf5::read_text_attribute(file, "sweep_toml"),
                          .sweep_hash = hdf5::read_text_attribute(file, "sweep_hash")};
    if (H5Aexists(file, "sweep_cases") > 0) {
        header.sweep_cases = {.count = hdf5::read_number_attribute(file, "sweep_cases"),
                              .ids_hash = hdf5::read_text_attribute(file, "sweep_case_ids_hash")};
    }
    return header;
}

/// case_id repeats in /states, so the rows' own numbers are what the columns are measured along.
Column state_column(std::size_t rows) {
    WholeNumbers numbers(rows);
    std::iota(numbers.begin(), numbers.end(), 0);
    return {.label = {"state", "1", "number of the row"}, .values = std::move(numbers)};
}

void write_states(const hdf5::File& file, Table states) {
    if (states.rows == 0) return;
    states.columns.insert(states.columns.begin(), state_column(states.rows));
    const hdf5::Group group = hdf5::open_group(file.id(), states_group);
    write_table(group.id(), states);
    attach_to_dimension(group.id(), "state");
}

}  // namespace

CampaignFile open_campaign(const std::filesystem::path& path) {
    now_reading(path);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw StoreError(fmt::format("{}: {}; expected a result file", path.string(),
                                     error ? error.message() : "is not a file"));
    }
    CampaignFile campaign{.file = hdf5::File(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)),
                          .header = {}};
    if (campaign.file.id() < 0) hdf5::fail(path, "cannot be read as an HDF5 result file");
    check_schema(campaign.file.id(), path);
    campaign.header = read_header(campaign.file.id());
    return campaign;
}

hdf5::File create_campaign(const std::filesystem::path& path, const CampaignHeader& header) {
    const auto creation = property_list(H5P_FILE_CREATE, path);
    const auto access = property_list(H5P_FILE_ACCESS, path);
    if (H5Pset_istore_k(creation.id(), chunk_index_half_width) < 0 ||
        H5Pset_obj_track_times(creation.id(), false) < 0 ||
        H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110) < 0) {
        hdf5::fail(path, "cannot prepare the file");
    }
    hdf5::File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()));
    if (file.id() < 0) hdf5::fail(path, "cannot create the file");

    hdf5::write_attribute(file.id(), "schema_version", schema_version);
    hdf5::write_attribute(file.id(), "created_utc", header.created_utc);
    hdf5::write_attribute(file.id(), "generator", header.generator);
    hdf5::write_attribute(file.id(), "sweep_toml", header.sweep_toml);
    hdf5::write_attribute(file.id(), "sweep_hash", header.sweep_hash);
    if (header.sweep_cases) {
        hdf5::write_attribute(file.id(), "sweep_cases", header.sweep_cases->count);
        hdf5::write_attribute(file.id(), "sweep_case_ids_hash", header.sweep_cases->ids_hash);
    }
    // Tables show their columns in the order in which they were written.
    for (const auto* name : {cases_group, states_group, provenance_group})
        hdf5::create_group(file.id(), name, true);
    for (const auto* name : {series_group, replay_group}) hdf5::create_group(file.id(), name);
    return file;
}

void write_tables(const hdf5::File& file, const Table& cases, Table states, const Table& provenance) {
    const hdf5::Group group = hdf5::open_group(file.id(), cases_group);
    write_table(group.id(), cases);
    attach_to_dimension(group.id(), "case_id");
    write_states(file, std::move(states));
    write_table(hdf5::open_group(file.id(), provenance_group).id(), provenance);
}

void finish_campaign(hdf5::File file, const std::filesystem::path& path) {
    hdf5::write_attribute(file.id(), "complete", 1);
    if (H5Fflush(file.id(), H5F_SCOPE_GLOBAL) < 0) hdf5::fail(path, "cannot write everything to the file");
    if (file.release() < 0) hdf5::fail(path, "cannot close the file");
}

Column case_id_column(Texts ids) {
    return {.label = {"case_id", "", "hash of the case's inputs"}, .values = std::move(ids)};
}

Column run_id_column(Texts ids) {
    return {.label = {"case_id", "", "case in whose run the state was found"}, .values = std::move(ids)};
}

Column build_id_column(Texts ids) {
    return {.label = {"build_id", "", "hash of the program"}, .values = std::move(ids)};
}

Column provenance_row_column(WholeNumbers rows) {
    return {.label = {"provenance_row", "1", "row of /provenance that tells how the case was run"},
            .values = std::move(rows)};
}

Column covered_cases_column(WholeNumbers counts) {
    return {.label = {"cases", "1", "number of cases that were run like this"}, .values = std::move(counts)};
}

}  // namespace trocar
