#include "results/replay_group.h"

#include <cstddef>

#include "results/hdf5_data.h"

namespace trocar {
namespace {

using Points = std::vector<StoredPoint>;

template <class Triple>
const auto* first_number(const std::vector<Triple>& triples) {
    return triples.empty() ? nullptr : triples.front().data();
}

void write_mesh(hid_t group, const Replay& replay) {
    const auto write = [&]<class Triple>(const char* name, const char* units, const char* long_name,
                                         const std::vector<Triple>& triples) {
        hdf5::write_numbers(group, {name, units, long_name}, {triples.size(), 3}, first_number(triples));
    };
    write("facets", "1", "vertices of each organ facet, counter-clockwise seen from outside", replay.facets);
    write("rest_positions", "mm", "organ vertices at rest", replay.rest_positions);
    write("tool_facets", "1", "vertices of each tool facet, counter-clockwise seen from outside",
          replay.tool_facets);
    write("tool_positions", "mm", "tool vertices in the tool's frame", replay.tool_positions);
}

/// One dataset [steps, points, 3], a chunk a step, so that a player reads one step without the others.
template <class PointsOfStep>
void write_motion(hid_t group, const hdf5::Label& label, const Replay& replay, std::size_t points,
                  PointsOfStep points_of_step) {
    const hdf5::Dataset dataset =
        hdf5::create_dataset(group, label, H5T_IEEE_F32LE, {replay.steps.size(), points, 3}, 1);
    for (std::size_t k = 0; k < replay.steps.size(); ++k) {
        const Points& found = points_of_step(replay.steps[k]);
        hdf5::write_row(dataset.id(), k, H5T_NATIVE_FLOAT, first_number(found));
    }
}

/// The tool's vertices in the world under a pose, for viewers that know points only.
void place_tool(const Replay& replay, const std::array<float, 16>& pose, Points& placed) {
    placed.resize(replay.tool_positions.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const StoredPoint& p = replay.tool_positions[i];
        for (std::size_t row = 0; row < 3; ++row) {
            const float* m = &pose[4 * row];
            placed[i][row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
        }
    }
}

void write_tool_motion(hid_t group, const Replay& replay) {
    std::vector<std::array<float, 16>> poses;
    for (const ReplayStep& step : replay.steps) poses.push_back(step.tool_pose);
    hdf5::write_numbers(group,
                        {"tool_pose", "mm", "tool frame to world, a matrix a step; its last column in mm"},
                        {poses.size(), 4, 4}, first_number(poses));
    hdf5::write_numbers(group, {"tool_start", "mm", "tool frame to world before the first step"}, {4, 4},
                        replay.tool_start.data());
    Points placed;
    write_motion(group, {"tool_placed", "mm", "tool vertices in the world"}, replay,
                 replay.tool_positions.size(), [&](const ReplayStep& step) -> const Points& {
                     place_tool(replay, step.tool_pose, placed);
                     return placed;
                 });
}

void write_moved(hid_t group, const Replay& replay) {
    std::vector<std::int32_t> moved;
    std::vector<std::array<double, 3>> moved_by;
    std::vector<std::int64_t> offsets{0};
    for (const ReplayStep& step : replay.steps) {
        moved.insert(moved.end(), step.moved.begin(), step.moved.end());
        moved_by.insert(moved_by.end(), step.moved_by.begin(), step.moved_by.end());
        offsets.push_back(static_cast<std::int64_t>(moved.size()));
    }
    hdf5::write_numbers(group, {"moved", "1", "vertices that the strategy displaced, step after step"},
                        {moved.size()}, moved.data());
    hdf5::write_numbers(group, {"moved_by", "mm", "how the strategy displaced each of them"},
                        {moved_by.size(), 3}, first_number(moved_by));
    hdf5::write_numbers(group,
                        {"moved_offsets", "1", "step k moved the vertices moved[offsets[k]:offsets[k+1]]"},
                        {offsets.size()}, offsets.data());
}

}  // namespace

void write_replay(hid_t group, const std::string& case_id, const Replay& replay) {
    const hdf5::Group own = hdf5::create_group(group, case_id);
    const std::size_t vertices = replay.rest_positions.size();
    write_mesh(own.id(), replay);
    const auto write = [&](const char* name, const char* long_name, Points ReplayStep::*points) {
        write_motion(own.id(), {name, "mm", long_name}, replay, vertices,
                     [&](const ReplayStep& step) -> const Points& { return step.*points; });
    };
    write("found", "organ vertices before handling", &ReplayStep::found);
    write("handled", "organ vertices after handling, before deformation", &ReplayStep::handled);
    write("deformed", "organ vertices after deformation", &ReplayStep::deformed);
    write_tool_motion(own.id(), replay);
    write_moved(own.id(), replay);
}

}  // namespace trocar
