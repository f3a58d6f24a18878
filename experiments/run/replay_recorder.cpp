#include "experiments/run/replay_recorder.h"

#include <limits>
#include <span>

namespace trocar {
namespace {

std::vector<StoredPoint> stored(std::span<const Vec3> positions) {
    std::vector<StoredPoint> points;
    points.reserve(positions.size());
    for (const Vec3& position : positions) {
        const Eigen::Vector3f point = position.cast<float>();
        points.push_back({point.x(), point.y(), point.z()});
    }
    return points;
}

std::array<float, 16> stored(const Pose& pose) {
    std::array<float, 16> matrix{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrix.at(4 * row + column) = static_cast<float>(pose.rotation(row, column));
        }
        matrix.at(4 * row + 3) = static_cast<float>(pose.position[row]);
    }
    matrix[15] = 1;
    return matrix;
}

}  // namespace

Replay empty_replay(const Organ& organ, const Tool& tool) {
    Replay replay{.facets = {organ.rest.facets.begin(), organ.rest.facets.end()},
                  .rest_positions = stored(organ.rest.positions),
                  .tool_positions = stored(tool.mesh.positions),
                  .tool_facets = {tool.mesh.facets.begin(), tool.mesh.facets.end()},
                  .tool_start = {},
                  .steps = {}};
    replay.tool_start.fill(std::numeric_limits<float>::quiet_NaN());
    return replay;
}

void record_start(Replay& replay, const Pose& start) { replay.tool_start = stored(start); }

void record_detected(Replay& replay, const Cycle& cycle) {
    ReplayStep& step = replay.steps.emplace_back();
    step.found = stored(cycle.positions());
    step.tool_pose = stored(cycle.tool().pose());
}

void record_handled(Replay& replay, const Cycle& cycle) {
    ReplayStep& step = replay.steps.back();
    step.handled = stored(cycle.positions());
    for (const auto& [vertex, displacement] : cycle.response().displacements) {
        step.moved.push_back(vertex);
        step.moved_by.push_back({displacement.x(), displacement.y(), displacement.z()});
    }
}

void record_deformed(Replay& replay, const Cycle& cycle) {
    replay.steps.back().deformed = stored(cycle.positions());
}

}  // namespace trocar
