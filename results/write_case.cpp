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

bool same_column(const Cell& a, const Cell& b) {
    return a.name == b.name && a.units == b.units && a.long_name == b.long_name &&
           a.value.index() == b.value.index();
}

void check_states(const std::filesystem::path& file, const std::vector<std::vector<Cell>>& states) {
    for (std::size_t row = 0; row < states.size(); ++row) {
        for (const Cell& cell : states[row]) check_name(file, cell.name);
        if (!std::ranges::equal(states[row], states.front(), same_column))
            refuse(file, fmt::format("state {} has not the columns of the first", row));
    }
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
    check_states(file, record.states);
    if (record.replay) check_replay(file, *record.replay, record.time.size());
}

Table cases_table(const CaseRecord& record) {
    Table table = table_of(record.cells);
    table.columns.insert(table.columns.begin(),
                         {case_id_column({record.case_id}), build_id_column({record.build_id})});
    table.columns.push_back(provenance_row_column({0}));
    return table;
}

Table states_table(const CaseRecord& record) {
    const std::vector<std::vector<Cell>>& states = record.states;
    if (states.empty()) return {};
    Table table{.columns = {run_id_column(Texts(states.size(), record.case_id))}, .rows = states.size()};
    for (std::size_t i = 0; i < states.front().size(); ++i) {
        const Cell& first = states.front()[i];
        std::visit(
            [&]<class T>(const T&) {
                std::vector<T> values;
                for (const std::vector<Cell>& row : states) values.push_back(std::get<T>(row[i].value));
                table.columns.push_back(
                    {.label = {first.name, first.units, first.long_name}, .values = std::move(values)});
            },
            first.value);
    }
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
        return hdf5::write_numbers(own.id(), label, {values.size()}, values.data());
    };
    write({"time", "s", "end of the step"}, record.time);
    for (const Series& series : record.series) {
        const hdf5::Dataset dataset = write({series.name, series.units, series.long_name}, series.values);
        if (!series.missing.empty()) hdf5::write_attribute(dataset.id(), "missing", series.missing);
    }
}

}  // namespace

void write_case(const std::filesystem::path& file, const CampaignHeader& header, const CaseRecord& record) {
    check(file, record);
    const hdf5::Session session;
    PendingFile pending(file);
    hdf5::File campaign = create_campaign(pending.temporary(), header);
    write_tables(campaign, cases_table(record), states_table(record), provenance_table(record));
    write_series(hdf5::open_group(campaign.id(), series_group).id(), record);
    if (record.replay) {
        write_replay(hdf5::open_group(campaign.id(), replay_group).id(), record.case_id, *record.replay);
    }
    finish_campaign(std::move(campaign), pending.temporary());
    pending.publish();
}

}  // namespace trocar
