#include "experiments/scenes/mean_normal.h"

#include <unordered_set>
#include <vector>

namespace trocar {

Vec3 mean_normal(const Organ& organ, const Vec3& point, Index facet, double radius) {
    const auto& p = organ.rest.positions;
    std::vector<Index> connected{facet};
    std::unordered_set<Index> seen{facet};
    Vec3 sum = Vec3::Zero();
    // The list grows while it is walked: a flood over shared vertices.
    for (std::size_t next = 0; next < connected.size(); ++next) {
        sum += organ.rest_areas[connected[next]] * organ.rest_normals[connected[next]];
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
    return sum.normalized();
}

}  // namespace trocar
