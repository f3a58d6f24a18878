#include "results/campaign_file.h"
#include "results/store.h"

namespace trocar {
namespace {

/// The values of a column that not every file has: then empty texts.
Texts texts_if_there(const Table& table, const std::string& name, hid_t group) {
    return table.find(name) == nullptr ? Texts(table.rows) : texts(table, name, group);
}

}  // namespace

Contents read_contents(const std::filesystem::path& file) {
    const hdf5::Session session;
    CampaignFile campaign = open_campaign(file);
    const hdf5::Group group = hdf5::open_group(campaign.file.id(), cases_group);
    const hdf5::Group replays = hdf5::open_group(campaign.file.id(), replay_group);
    const Table cases = read_table(group.id());
    const Texts& case_ids = texts(cases, "case_id", group.id());
    const Texts& build_ids = texts(cases, "build_id", group.id());
    const Texts& status = texts(cases, "status", group.id());
    const Texts metrics = texts_if_there(cases, "metrics", group.id());

    Contents contents{.header = std::move(campaign.header), .cases = {}};
    for (std::size_t i = 0; i < cases.rows; ++i) {
        contents.cases.push_back({.case_id = case_ids[i],
                                  .build_id = build_ids[i],
                                  .status = status[i],
                                  .has_replay = hdf5::exists(replays.id(), case_ids[i]),
                                  .metrics = metrics[i]});
    }
    return contents;
}

}  // namespace trocar
