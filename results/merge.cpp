#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "results/campaign_file.h"
#include "results/pending_file.h"
#include "results/store.h"
#include "results/supervised.h"
#include "results/table_merger.h"

namespace trocar {
namespace {

/// What the parts hold, in the order of the parts.
struct Collected {
    TableMerger cases;   ///< without provenance_row
    TableMerger states;  ///< without the rows' numbers
    std::map<std::string, std::vector<std::size_t>> states_of_case;
    TableMerger provenance;                    ///< without the counts; rows may repeat
    std::vector<std::size_t> provenance_rows;  ///< of each case
    std::map<std::string, std::size_t> row_of_case;
    std::vector<std::vector<std::string>> ids_of_part;
};

/// The rows of `ids` that the part is to give.
std::vector<std::size_t> chosen_rows(const Part& part, const Texts& ids) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < ids.size(); ++row) {
        if (part.case_ids.empty() || part.case_ids.contains(ids[row])) rows.push_back(row);
    }
    if (!part.case_ids.empty() && rows.size() != part.case_ids.size()) {
        throw StoreError(fmt::format("{}: holds {} of the {} cases that are to be taken from it",
                                     part.file.string(), rows.size(), part.case_ids.size()));
    }
    return rows;
}

/// Takes in the states of the part's cases `ids`.
void collect_states(const CampaignFile& campaign, const Part& part, const std::vector<std::string>& ids,
                    Collected& collected) {
    const hdf5::Group group = hdf5::open_group(campaign.file.id(), states_group);
    Table states = read_table(group.id());
    if (states.rows == 0) return;
    const Texts runs = texts(states, "case_id", group.id());
    states.erase("state");
    const std::set<std::string> wanted(ids.begin(), ids.end());
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < states.rows; ++row) {
        if (!wanted.contains(runs[row])) continue;
        collected.states_of_case[runs[row]].push_back(collected.states.rows() + rows.size());
        rows.push_back(row);
    }
    collected.states.append(states, rows, part.file.string());
}

void collect_part(const Part& part, const CampaignHeader& header, Collected& collected) {
    const CampaignFile campaign = open_campaign(part.file);
    if (campaign.header.sweep_hash != header.sweep_hash) {
        throw StoreError(
            fmt::format("{}: comes from another sweep (hash {}, expected {}); merge only results of "
                        "one sweep",
                        part.file.string(), campaign.header.sweep_hash, header.sweep_hash));
    }
    const hdf5::Group cases_at = hdf5::open_group(campaign.file.id(), cases_group);
    const hdf5::Group provenance_at = hdf5::open_group(campaign.file.id(), provenance_group);
    Table cases = read_table(cases_at.id());
    Table provenance = read_table(provenance_at.id());
    const Texts ids = texts(cases, "case_id", cases_at.id());
    const WholeNumbers provenance_rows = whole_numbers(cases, "provenance_row", cases_at.id());
    cases.erase("provenance_row");
    provenance.erase("cases");

    const std::vector<std::size_t> rows = chosen_rows(part, ids);
    auto& ids_here = collected.ids_of_part.emplace_back();
    for (const std::size_t row : rows) {
        const std::int64_t provenance_row = provenance_rows[row];
        if (provenance_row < 0 || static_cast<std::size_t>(provenance_row) >= provenance.rows)
            hdf5::refuse(cases_at.id(), "provenance_row", "names a row that /provenance does not have");
        if (!collected.row_of_case.emplace(ids[row], collected.row_of_case.size()).second) {
            throw StoreError(
                fmt::format("{}: holds case {}, which was found before; name the cases to take from "
                            "each file",
                            part.file.string(), ids[row]));
        }
        collected.provenance_rows.push_back(collected.provenance.rows() +
                                            static_cast<std::size_t>(provenance_row));
        ids_here.push_back(ids[row]);
    }
    collected.cases.append(cases, rows, part.file.string());
    std::vector<std::size_t> every_row(provenance.rows);
    std::iota(every_row.begin(), every_row.end(), 0);
    collected.provenance.append(provenance, every_row, part.file.string());
    collect_states(campaign, part, ids_here, collected);
}

/// For each case of the merged file, in its order, the row it was collected in.
std::vector<std::size_t> rows_in_order(const std::filesystem::path& out, const Collected& collected,
                                       std::span<const std::string> case_order) {
    std::map<std::string, std::size_t> not_taken = collected.row_of_case;
    std::vector<std::size_t> rows;
    for (const std::string& id : case_order) {
        const auto row = not_taken.find(id);
        if (row == not_taken.end()) {
            throw StoreError(fmt::format("{}: not merged: no part holds case {}, or the order names it twice",
                                         out.string(), id));
        }
        rows.push_back(row->second);
        not_taken.erase(row);
    }
    if (!not_taken.empty()) {
        throw StoreError(
            fmt::format("{}: not merged: the order does not name case {}, which a part holds; name "
                        "the cases to take from each file",
                        out.string(), not_taken.begin()->first));
    }
    return rows;
}

/// A text that is the same for two rows exactly when they are equal.
std::vector<std::string> row_keys(const Table& table) {
    std::vector<std::string> keys(table.rows);
    for (const Column& column : table.columns) {
        std::visit(
            [&](const auto& values) {
                for (std::size_t row = 0; row < table.rows; ++row)
                    keys[row] += fmt::format("{}\x1f", values[row]);
            },
            column.values);
    }
    return keys;
}

Table states_in_order(const Collected& collected, std::span<const std::string> case_order) {
    std::vector<std::size_t> rows;
    for (const std::string& id : case_order) {
        const auto states = collected.states_of_case.find(id);
        if (states != collected.states_of_case.end())
            std::ranges::copy(states->second, std::back_inserter(rows));
    }
    return collected.states.in_order(rows);
}

void write_merged_tables(const hdf5::File& file, const Collected& collected,
                         std::span<const std::size_t> rows, std::span<const std::string> case_order) {
    std::vector<std::size_t> every_row(collected.provenance.rows());
    std::iota(every_row.begin(), every_row.end(), 0);
    const std::vector<std::string> keys = row_keys(collected.provenance.in_order(every_row));

    std::map<std::string, std::size_t> distinct;  // key → row in the merged file
    std::vector<std::size_t> kept;                // row in the merged file → row collected
    WholeNumbers counts;
    WholeNumbers provenance_rows;
    for (const std::size_t row : rows) {
        const std::size_t source = collected.provenance_rows[row];
        const auto [known, is_new] = distinct.try_emplace(keys[source], kept.size());
        if (is_new) {
            kept.push_back(source);
            counts.push_back(0);
        }
        ++counts[known->second];
        provenance_rows.push_back(static_cast<std::int64_t>(known->second));
    }
    Table cases = collected.cases.in_order(rows);
    cases.columns.push_back(provenance_row_column(std::move(provenance_rows)));
    Table provenance = collected.provenance.in_order(kept);
    provenance.columns.push_back(covered_cases_column(std::move(counts)));
    write_tables(file, cases, states_in_order(collected, case_order), provenance);
}

void copy_group(hid_t from, hid_t to, const std::string& path) {
    hdf5::checked(H5Ocopy(from, path.c_str(), to, path.c_str(), H5P_DEFAULT, H5P_DEFAULT), from, path,
                  "cannot be copied into the merged file");
}

/// HDF5 keeps some of every group it copies until the source is closed: closing it now and then bounds that.
constexpr std::size_t copies_per_opening = 64;

void copy_groups(const hdf5::File& to, const Part& part, const std::vector<std::string>& ids) {
    CampaignFile from;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i % copies_per_opening == 0) {
            from = {};
            from = open_campaign(part.file);
        }
        now_reading(part.file);
        for (const char* group : {series_group, replay_group}) {
            const std::string path = fmt::format("{}/{}", group, ids[i]);
            if (hdf5::exists(from.file.id(), path)) copy_group(from.file.id(), to.id(), path);
        }
    }
}

/// As much as one write to a file may take, bytes.
constexpr std::uintmax_t largest_write = 1U << 20U;

/// libhdf5 1.10.8 crashes, too, where it copies to a disk that is full: then no part is to blame.
void supervised_on_disk(const std::filesystem::path& written, std::span<const Part> parts,
                        const std::function<std::string()>& action) {
    std::vector<std::filesystem::path> files;
    for (const Part& part : parts) files.push_back(part.file);
    try {
        supervised(files, action);
    } catch (const DamagedFile&) {
        std::error_code error;
        const std::filesystem::space_info disk = std::filesystem::space(written, error);
        if (error || disk.available > largest_write) throw;
        throw StoreError(fmt::format("{}: cannot be written: {}", written.string(),
                                     std::make_error_code(std::errc::no_space_on_device).message()));
    }
}

}  // namespace

void merge(const std::filesystem::path& out, const CampaignHeader& header, std::span<const Part> parts,
           std::span<const std::string> case_order, Merged what) {
    if (case_order.empty()) throw StoreError(fmt::format("{}: not merged: there are no cases", out.string()));
    PendingFile pending(out);
    supervised_on_disk(pending.temporary(), parts, [&] {
        Collected collected;
        for (const Part& part : parts) collect_part(part, header, collected);
        const std::vector<std::size_t> rows = rows_in_order(out, collected, case_order);
        hdf5::File file = create_campaign(pending.temporary(), header);
        write_merged_tables(file, collected, rows, case_order);
        if (what == Merged::everything) {
            for (std::size_t i = 0; i < parts.size(); ++i)
                copy_groups(file, parts[i], collected.ids_of_part[i]);
        }
        finish_campaign(std::move(file), pending.temporary());
        return std::string();
    });
    pending.publish();
}

}  // namespace trocar
