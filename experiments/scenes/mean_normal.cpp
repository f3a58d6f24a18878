#include "experiments/scenes/mean_normal.h"

#include <unordered_set>
#include <vector>

namespace trocar {
namespace {

constexpr double cancelled = 1e-9;  // of the area: what rounding leaves of a closed surface's sum

}  // namespace

std::optional<Vec3> mean_normal(const Organ& organ, const Vec3& point, Index facet, double radius) {
    const auto& p = organ.rest.positions;
    std::vector<Index> connected{facet};
    std::unordered_set<Index> seen{facet};
    Vec3 sum = Vec3::Zero();
    double area = 0;
    // The list grows while it is walked: a flood over shared vertices.
    for (std::size_t next = 0; next < connected.size(); ++next) {
        sum += organ.rest_areas[connected[next]] * organ.rest_normals[connected[next]];
        area += organ.rest_areas[connected[next]];
        for (const Index vertex : organ.rest.facets[connected[next]]) {
            for (const Index beside : organ.adjacency.ring(vertex)) {
                const auto [a, b, c] = organ.rest.facets[beside];
                const Vec3 centre = (p[a] + p[b] + p[c]) / 3;
                if ((centre - point).norm() <= radius && seen.insert(beside).second) {
                    connected.push_back(beside);
                }
            }
        }
    }
    if (sum.norm() <= cancelled * area) return std::nullopt;
    return sum.normalized();
}

}  // namespace trocar
