#include "experiments/metrics/judge/region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "common/geometry/surface_queries.h"

namespace trocar {
namespace {

/// No point of the tool goes further than this between two poses, mm.
double furthest_move(const Box& tool, const Pose& from, const Pose& to) {
    double longest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 point;
        for (int k = 0; k < 3; ++k) point[k] = (corner >> k) % 2 == 0 ? tool.low[k] : tool.high[k];
        longest = std::max(longest, (to.to_world(point) - from.to_world(point)).norm());
    }
    constexpr double arc_over_chord = std::numbers::pi / 2;  // of half a turn
    return longest * arc_over_chord;
}

/// Gathers the vertices that a tool comes near.
class Sweep {
  public:
    Sweep(const Organ& organ, const Tool& tool)
        : rest_(organ.rest.positions),
          surface_(tool.mesh),
          reach_(2 * tool.radius),
          box_(bounding_box(tool.mesh.positions).grown(reach_)),
          others_(rest_.size()) {
        std::iota(others_.begin(), others_.end(), 0);
    }

    void look(const Pose& pose) {
        std::erase_if(others_, [&](Index vertex) {
            const Vec3 in_tool = judged_position(pose, rest_[vertex]);
            const bool near = box_.contains(in_tool) &&
                              (surface_.distance(in_tool) <= reach_ || surface_.contains(in_tool));
            if (near) near_.push_back(vertex);
            return near;
        });
    }

    /// Ascending.
    [[nodiscard]] std::vector<Index> near() {
        std::ranges::sort(near_);
        return near_;
    }

  private:
    const std::vector<Vec3>& rest_;
    SurfaceQueries surface_;
    double reach_;
    Box box_;
    std::vector<Index> near_, others_;
};

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

std::vector<Index> vertices_near_sweep(const Organ& organ, const Tool& tool, const Pose& start,
                                       std::span<const Pose> poses) {
    Sweep sweep(organ, tool);
    sweep.look(start);
    Pose last = start;
    for (const Pose& pose : poses) {
        const double furthest = furthest_move(bounding_box(tool.mesh.positions), last, pose);
        const int parts = static_cast<int>(std::ceil(furthest / (tool.radius / 4)));
        for (int part = 1; part <= parts; ++part) {
            sweep.look(between(last, pose, static_cast<double>(part) / parts));
        }
        last = pose;
    }
    return sweep.near();
}

}  // namespace trocar
