#include "experiments/metrics/region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "common/geometry/surface_queries.h"

namespace trocar {
namespace {

/// The furthest that a point of the tool goes between two poses is at most this, mm.
double furthest(const Box& tool, const Pose& from, const Pose& to) {
    double longest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 point;
        for (int k = 0; k < 3; ++k) point[k] = (corner >> k) % 2 == 0 ? tool.low[k] : tool.high[k];
        longest = std::max(longest, (to.to_world(point) - from.to_world(point)).norm());
    }
    constexpr double arc_over_chord = std::numbers::pi / 2;  // of half a turn
    return longest * arc_over_chord;
}

Pose between(const Pose& from, const Pose& to, double part) {
    const Eigen::Quaterniond one(from.rotation), other(to.rotation);
    return {.rotation = one.slerp(part, other).toRotationMatrix(),
            .position = from.position + part * (to.position - from.position)};
}

}  // namespace

Region region_of(const JudgedOrgan& organ, std::vector<Index> vertices) {
    std::vector<bool> within(organ.rest().positions.size(), false);
    for (const Index vertex : vertices) within[vertex] = true;
    Region region{.vertices = std::move(vertices), .edges = {}};
    for (std::size_t edge = 0; edge < organ.edges().size(); ++edge) {
        const auto& [a, b] = organ.edges()[edge];
        if (within[a] && within[b]) region.edges.push_back(static_cast<Index>(edge));
    }
    return region;
}

std::vector<Index> vertices_near_sweep(const Organ& organ, const Tool& tool, std::span<const Pose> poses) {
    const SurfaceQueries surface(tool.mesh);
    const Box box = bounding_box(tool.mesh.positions), reach = box.grown(2 * tool.radius);
    const std::vector<Vec3>& rest = organ.rest.positions;
    std::vector<Index> found;
    std::vector<Index> others(rest.size());
    for (std::size_t vertex = 0; vertex < rest.size(); ++vertex) others[vertex] = static_cast<Index>(vertex);
    const auto look = [&](const Pose& pose) {
        const auto near = [&](Index vertex) {
            const Vec3 in_tool = judged_position(pose, rest[vertex]);
            return reach.contains(in_tool) &&
                   (surface.distance(in_tool) <= 2 * tool.radius || surface.contains(in_tool));
        };
        const auto far_end = std::partition(others.begin(), others.end(), [&](Index v) { return !near(v); });
        found.insert(found.end(), far_end, others.end());
        others.erase(far_end, others.end());
    };
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const Pose& from = poses[k == 0 ? 0 : k - 1];
        const int parts =
            std::max(1, static_cast<int>(std::ceil(furthest(box, from, poses[k]) / (tool.radius / 4))));
        if (k > 0 && from.position == poses[k].position && from.rotation == poses[k].rotation) continue;
        for (int part = 1; part <= parts; ++part) look(between(from, poses[k], double(part) / parts));
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace trocar
