#include "results/xdmf.h"

#include <array>
#include <fstream>

#include <fmt/format.h>

#include "results/campaign_file.h"
#include "results/pending_file.h"
#include "results/supervised.h"

namespace trocar {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// Where the replay of a case is, and how large.
struct ReplayShape {
    std::string location;  ///< "<file>:/replay/<case_id>", escaped
    hsize_t steps = 0, vertices = 0, facets = 0, tool_vertices = 0, tool_facets = 0;
};

hsize_t rows(hid_t group, const char* name, std::size_t dimensions) {
    const auto shape = hdf5::shape_of(hdf5::open_dataset(group, name).id());
    if (shape.size() != dimensions || shape.back() != 3)
        hdf5::refuse(group, name, fmt::format("expected {} dimensions, the last of length 3", dimensions));
    return shape.front();
}

ReplayShape shape_of_replay(hid_t group, const std::string& location) {
    ReplayShape replay{.location = location,
                       .steps = rows(group, "deformed", 3),
                       .vertices = rows(group, "rest_positions", 2),
                       .facets = rows(group, "facets", 2),
                       .tool_vertices = rows(group, "tool_positions", 2),
                       .tool_facets = rows(group, "tool_facets", 2)};
    for (const auto* name : {"found", "handled", "tool_placed"}) {
        if (rows(group, name, 3) != replay.steps)
            hdf5::refuse(group, name, "expected as many steps as in deformed");
    }
    return replay;
}

std::string topology(const ReplayShape& replay, const char* dataset, hsize_t facets) {
    return fmt::format(
        R"(<Topology TopologyType="Triangle" NumberOfElements="{0}">)"
        R"(<DataItem Dimensions="{0} 3" NumberType="Int" Precision="4" Format="HDF">{1}/{2}</DataItem>)"
        "</Topology>\n",
        facets, replay.location, dataset);
}

/// Step `step` of a dataset [steps, points, 3], as start : stride : count : size of the whole. That is what
/// the readers of XDMF 3 in ParaView understand; out of an element HyperSlab, which those of XDMF 2 want,
/// they get no points.
std::string points_of_step(const ReplayShape& replay, const char* dataset, hsize_t step, hsize_t points) {
    return fmt::format(R"(<DataItem Dimensions="{3} 3" NumberType="Float" Precision="4" Format="HDF">)"
                       "{0}/{1}|{2} 0 0:1 1 1:1 {3} 3:{4} {3} 3</DataItem>",
                       replay.location, dataset, step, points, replay.steps);
}

std::string organ_grid(const ReplayShape& replay, hsize_t step) {
    std::string grid =
        "<Grid Name=\"organ\" GridType=\"Uniform\">\n" + topology(replay, "facets", replay.facets);
    grid += fmt::format("<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                        points_of_step(replay, "deformed", step, replay.vertices));
    for (const auto* name : {"found", "handled"}) {
        grid +=
            fmt::format("<Attribute Name=\"{}\" AttributeType=\"Vector\" Center=\"Node\">{}</Attribute>\n",
                        name, points_of_step(replay, name, step, replay.vertices));
    }
    return grid + "</Grid>\n";
}

std::string tool_grid(const ReplayShape& replay, hsize_t step) {
    return fmt::format(
        "<Grid Name=\"tool\" GridType=\"Uniform\">\n{}<Geometry GeometryType=\"XYZ\">{}</Geometry>\n"
        "</Grid>\n",
        topology(replay, "tool_facets", replay.tool_facets),
        points_of_step(replay, "tool_placed", step, replay.tool_vertices));
}

void write_case(std::ostream& out, const std::string& name, const ReplayShape& replay, const Figures& time) {
    out << fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
                       escaped(name));
    for (hsize_t step = 0; step < replay.steps; ++step) {
        out << fmt::format(
                   "<Grid Name=\"step {}\" GridType=\"Collection\" CollectionType=\"Spatial\">\n"
                   "<Time Value=\"{}\"/>\n",
                   step, time[step])
            << organ_grid(replay, step) << tool_grid(replay, step) << "</Grid>\n";
    }
    out << "</Grid>\n";
}

Figures read_time(hid_t file, const std::string& case_id, hsize_t steps) {
    const hdf5::Group series = hdf5::open_group(file, fmt::format("{}/{}", series_group, case_id));
    Column time = read_column(series.id(), "time");
    auto* values = std::get_if<Figures>(&time.values);
    if (values == nullptr || values->size() != steps)
        hdf5::refuse(series.id(), "time",
                     fmt::format("expected {} figures, one for each step of the replay", steps));
    return std::move(*values);
}

void write_domain(std::ostream& out, hid_t file, const std::string& file_name,
                  const std::optional<std::string>& only_case) {
    const hdf5::Group cases_at = hdf5::open_group(file, cases_group);
    const hdf5::Group replays = hdf5::open_group(file, replay_group);
    constexpr std::array shown{"case_id", "strategy"};
    const Table cases = read_table(cases_at.id(), shown);
    const Texts& ids = texts(cases, "case_id", cases_at.id());
    const Column* strategy = cases.find("strategy");
    const Texts* strategies = strategy == nullptr ? nullptr : std::get_if<Texts>(&strategy->values);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!hdf5::exists(replays.id(), ids[i]) || (only_case && ids[i] != *only_case)) continue;
        const ReplayShape replay =
            shape_of_replay(hdf5::open_group(replays.id(), ids[i]).id(),
                            escaped(fmt::format("{}:/{}/{}", file_name, replay_group, ids[i])));
        const std::string name = strategies == nullptr ? ids[i] : (*strategies)[i] + " " + ids[i];
        write_case(out, name, replay, read_time(file, ids[i], replay.steps));
    }
}

}  // namespace

void write_xdmf(const std::filesystem::path& campaign, const std::filesystem::path& out_xdmf,
                const std::optional<std::string>& only_case) {
    PendingFile pending(out_xdmf);
    supervised({&campaign, 1}, [&] {
        const CampaignFile from = open_campaign(campaign);
        if (hdf5::member_names(hdf5::open_group(from.file.id(), replay_group).id()).empty()) {
            throw StoreError(
                fmt::format("{}: holds no replay, so there is nothing to show", campaign.string()));
        }
        std::ofstream out(pending.temporary());
        out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
        write_domain(out, from.file.id(),
                     std::filesystem::proximate(campaign, out_xdmf.parent_path()).string(), only_case);
        out << "</Domain>\n</Xdmf>\n";
        out.close();
        if (!out) throw StoreError(fmt::format("{}: cannot be written", out_xdmf.string()));
        return std::string();
    });
    pending.publish();
}

}  // namespace trocar
