#include <algorithm>

#include <fmt/format.h>

#include "results/campaign_file.h"
#include "results/pending_file.h"
#include "results/replay_group.h"
#include "results/store.h"

namespace trocar {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
    throw StoreError(fmt::format("{}: not written: {}", file.string(), reason));
}

/// Names become names of groups and datasets.
void check_name(const std::filesystem::path& file, const std::string& name) {
    if (name.empty() || name == "." || name.find_first_of(std::string_view("/\0", 2)) != std::string::npos)
        refuse(file, fmt::format("\"{}\" cannot name a case, column or series", name));
}

void check_status(const std::filesystem::path& file, const std::vector<Cell>& cells) {
    const auto cell = std::ranges::find(cells, "status", &Cell::name);
    if (cell == cells.end()) refuse(file, "the case has no cell status");
    const auto* text = std::get_if<std::string>(&cell->value);
    constexpr std::array all{CaseStatus::complete,  CaseStatus::diverged,      CaseStatus::failed,
                             CaseStatus::timed_out, CaseStatus::out_of_memory, CaseStatus::crashed};
    if (text == nullptr || std::ranges::find(all, *text, status_name) == all.end())
        refuse(file, "the cell status is not the name of a status");
}

void check_replay(const std::filesystem::path& file, const Replay& replay, std::size_t steps) {
    if (replay.steps.size() != steps)
        refuse(file, fmt::format("the replay has {} steps, the case {}", replay.steps.size(), steps));
    const std::size_t vertices = replay.rest_positions.size();
    for (const ReplayStep& step : replay.steps) {
        if (step.found.size() != vertices || step.handled.size() != vertices ||
            step.deformed.size() != vertices)
            refuse(file, fmt::format("a step of the replay has not the organ's {} vertices", vertices));
    }
}

void check(const std::filesystem::path& file, const CaseRecord& record) {
    check_name(file, record.case_id);
    for (const Cell& cell : record.cells) check_name(file, cell.name);
    check_status(file, record.cells);
    for (const Series& series : record.series) {
        check_name(file, series.name);
        if (!series.values.empty() && series.values.size() != record.time.size()) {
            refuse(file, fmt::format("the series {} has {} values, the case {} steps", series.name,
                                     series.values.size(), record.time.size()));
        }
    }
    if (record.replay) check_replay(file, *record.replay, record.time.size());
}

Table cases_table(const CaseRecord& record) {
    Table table = table_of(record.cells);
    table.columns.insert(table.columns.begin(),
                         {case_id_column({record.case_id}), build_id_column({record.build_id})});
    table.columns.push_back(provenance_row_column({0}));
    return table;
}

Table provenance_table(const CaseRecord& record) {
    Table table = table_of(record.provenance);
    table.columns.push_back(covered_cases_column({1}));
    return table;
}

void write_series(hid_t group, const CaseRecord& record) {
    const hdf5::Group own = hdf5::create_group(group, record.case_id);
    const auto write = [&](const hdf5::Label& label, const std::vector<double>& values) {
        hdf5::write_numbers(own.id(), label, {values.size()}, values.data());
    };
    write({"time", "s", "end of the step"}, record.time);
    for (const Series& series : record.series)
        write({series.name, series.units, series.long_name}, series.values);
}

}  // namespace

void write_case(const std::filesystem::path& file, const CampaignHeader& header, const CaseRecord& record) {
    check(file, record);
    const hdf5::Session session;
    PendingFile pending(file);
    hdf5::File campaign = create_campaign(pending.temporary(), header);
    write_tables(campaign, cases_table(record), provenance_table(record));
    write_series(hdf5::open_group(campaign.id(), series_group).id(), record);
    if (record.replay) {
        write_replay(hdf5::open_group(campaign.id(), replay_group).id(), record.case_id, *record.replay);
    }
    finish_campaign(std::move(campaign), pending.temporary());
    pending.publish();
}

}  // namespace trocar
