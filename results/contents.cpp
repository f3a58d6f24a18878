#include <array>
#include <charconv>

#include <fmt/format.h>

#include "results/campaign_file.h"
#include "results/store.h"
#include "results/supervised.h"

namespace trocar {
namespace {

constexpr std::array case_columns{"case_id",  "build_id",     "status",        "metrics",
                                  "attempts", "sweep_number", "provenance_row"};

/// A text of each row of a table, empty where not every file has the column.
Texts texts_if_there(const Table& table, const std::string& name, hid_t group) {
    return table.find(name) == nullptr ? Texts(table.rows) : texts(table, name, group);
}

WholeNumbers numbers_if_there(const Table& table, const std::string& name, hid_t group) {
    return table.find(name) == nullptr ? WholeNumbers(table.rows) : whole_numbers(table, name, group);
}

/// Adds to each case what its row of /provenance says.
void add_provenance(hid_t file, const WholeNumbers& rows, std::vector<Contents::Case>& cases) {
    const hdf5::Group group = hdf5::open_group(file, provenance_group);
    const Table provenance = read_table(group.id());
    const Texts ends = texts_if_there(provenance, "end", group.id());
    const Texts hosts = texts_if_there(provenance, "host", group.id());
    const Texts processors = texts_if_there(provenance, "cpu", group.id());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto row = static_cast<std::size_t>(rows[i]);
        if (row >= provenance.rows)
            hdf5::refuse(group.id(), "", fmt::format("a case names row {}, which is not there", rows[i]));
        cases[i].end = ends[row];
        cases[i].machine = fmt::format("{} ({})", hosts[row], processors[row]);
    }
}

Contents read_here(const std::filesystem::path& file) {
    CampaignFile campaign = open_campaign(file);
    const hdf5::Group group = hdf5::open_group(campaign.file.id(), cases_group);
    const hdf5::Group series = hdf5::open_group(campaign.file.id(), series_group);
    const hdf5::Group replays = hdf5::open_group(campaign.file.id(), replay_group);
    const Table cases = read_table(group.id(), case_columns);
    const Texts& case_ids = texts(cases, "case_id", group.id());
    const Texts& build_ids = texts(cases, "build_id", group.id());
    const Texts& status = texts(cases, "status", group.id());
    const Texts metrics = texts_if_there(cases, "metrics", group.id());
    const WholeNumbers attempts = numbers_if_there(cases, "attempts", group.id());
    const WholeNumbers numbers = numbers_if_there(cases, "sweep_number", group.id());

    Contents contents{.header = std::move(campaign.header), .cases = {}};
    for (std::size_t i = 0; i < cases.rows; ++i) {
        contents.cases.push_back({.case_id = case_ids[i],
                                  .build_id = build_ids[i],
                                  .status = status[i],
                                  .has_series = hdf5::exists(series.id(), case_ids[i]),
                                  .has_replay = hdf5::exists(replays.id(), case_ids[i]),
                                  .metrics = metrics[i],
                                  .attempts = attempts[i],
                                  .sweep_number = numbers[i],
                                  .end = {},
                                  .machine = {}});
    }
    add_provenance(campaign.file.id(), whole_numbers(cases, "provenance_row", group.id()), contents.cases);
    return contents;
}

std::string as_text(const Contents& contents) {
    const CampaignHeader& header = contents.header;
    std::vector<std::string> texts{header.created_utc,
                                   header.generator,
                                   header.sweep_toml,
                                   header.sweep_hash,
                                   header.sweep_cases ? fmt::format("{}", header.sweep_cases->count) : "",
                                   header.sweep_cases ? header.sweep_cases->ids_hash : ""};
    for (const Contents::Case& one : contents.cases) {
        texts.insert(texts.end(),
                     {one.case_id, one.build_id, one.status, one.has_series ? "series" : "",
                      one.has_replay ? "replay" : "", one.metrics, fmt::format("{}", one.attempts),
                      fmt::format("{}", one.sweep_number), one.end, one.machine});
    }
    return joined_texts(texts);
}

std::int64_t number_in(const std::string& text) {
    std::int64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// The inverse of as_text.
Contents contents_in(const std::string& text) {
    const std::vector<std::string> texts = split_texts(text);
    auto next = texts.begin();
    Contents contents;
    CampaignHeader& header = contents.header;
    for (std::string* one : {&header.created_utc, &header.generator, &header.sweep_toml, &header.sweep_hash})
        *one = *next++;
    const CaseList list{.count = number_in(next[0]), .ids_hash = next[1]};
    if (!next->empty()) header.sweep_cases = list;
    next += 2;
    while (next != texts.end()) {
        Contents::Case& one = contents.cases.emplace_back();
        for (std::string* cell : {&one.case_id, &one.build_id, &one.status}) *cell = *next++;
        one.has_series = !(next++)->empty();
        one.has_replay = !(next++)->empty();
        one.metrics = *next++;
        one.attempts = number_in(*next++);
        one.sweep_number = number_in(*next++);
        for (std::string* cell : {&one.end, &one.machine}) *cell = *next++;
    }
    return contents;
}

}  // namespace

std::vector<Contents> read_contents(std::span<const std::filesystem::path> files) {
    const std::string all = supervised(files, [&] {
        std::vector<std::string> each;
        for (const auto& file : files) each.push_back(as_text(read_here(file)));
        return joined_texts(each);
    });
    std::vector<Contents> contents;
    for (const std::string& one : split_texts(all)) contents.push_back(contents_in(one));
    return contents;
}

Contents read_contents(const std::filesystem::path& file) { return read_contents({&file, 1}).front(); }

}  // namespace trocar
