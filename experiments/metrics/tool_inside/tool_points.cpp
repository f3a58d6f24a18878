#include "experiments/metrics/tool_inside/tool_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace trocar {

// The surface is gone over facet by facet, each from its first corner to the opposite edge, and the k-th
// point put where k + 1/2 of the points' shares of area have been passed. How far along the line there,
// parallel to that edge, is Kronecker's sequence of the golden ratio, which spreads neighbours in k apart.
std::vector<Vec3> tool_points(const SurfaceMesh& tool) {
    const std::vector<double> areas = facet_areas(tool);
    double total = 0;
    for (const double area : areas) total += area;
    const double share = total / std::max(1.0, std::round(total));  // mm² per point
    std::vector<Vec3> points;
    double passed = 0;  // mm²
    for (std::size_t facet = 0; facet < areas.size(); ++facet) {
        const auto& [a, b, c] = tool.facets[facet];
        const Vec3 corner = tool.positions[a], to_b = tool.positions[b] - corner,
                   b_to_c = tool.positions[c] - tool.positions[b];
        const auto k = [&] { return static_cast<double>(points.size()); };
        for (double at = (k() + 0.5) * share; at < passed + areas[facet]; at = (k() + 0.5) * share) {
            const double down = std::sqrt(std::max(0.0, at - passed) / areas[facet]);
            const double along = k() * (std::numbers::phi - 1);
            points.emplace_back(corner + down * (to_b + (along - std::floor(along)) * b_to_c));
        }
        passed += areas[facet];
    }
    std::ranges::sort(points, {}, [](const Vec3& point) { return point.x(); });
    return points;
}

}  // namespace trocar
