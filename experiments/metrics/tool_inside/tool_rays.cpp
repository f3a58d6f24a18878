#include "experiments/metrics/tool_inside/tool_rays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "experiments/metrics/tool_inside/columns.h"

namespace trocar {
namespace {

constexpr double wanted_rays = 4000;
constexpr double lowest = std::numeric_limits<double>::lowest();
constexpr double most_rays = 64000;  // over the box, for a tool whose cross-section hardly fills it

std::vector<Corners> corners_of(const SurfaceMesh& mesh) {
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : mesh.facets) {
        corners.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
    }
    return corners;
}

/// Area of the tool's shadow along z; where it is several layers thick each counts. mm².
double shadow_area(const SurfaceMesh& mesh) {
    double area = 0;
    for (const Facet& facet : mesh.facets) {
        area += std::max(0.0, facet_area_vector(mesh.positions, facet).z());
    }
    return area;
}

/// Kronecker's lattice of the golden ratio over the box: evenly spread in any direction, ascending by x.
std::vector<Vec3> lattice(const Box& box, std::size_t count) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double turns = (static_cast<double>(k) + 0.5) * (std::numbers::phi - 1);
        points.emplace_back(
            box.low.x() + box.size().x() * (static_cast<double>(k) + 0.5) / static_cast<double>(count),
            box.low.y() + box.size().y() * (turns - std::floor(turns)), 0);
    }
    return points;
}

}  // namespace

ToolRays::ToolRays(const SurfaceMesh& tool) {
    const Box box = bounding_box(tool.positions);
    const double box_area = box.size().x() * box.size().y();
    const double count = std::min(most_rays, std::ceil(wanted_rays * box_area / shadow_area(tool)));
    const std::vector<Vec3> points = lattice(box, static_cast<std::size_t>(count));
    cell_ = box_area / count;
    const Crossings crossings(points, corners_of(tool));
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto met = crossings.of(k);
        std::vector<Interval> inside;
        int winding = 0;
        for (std::size_t next = 1; next < met.size(); ++next) {
            winding += met[next - 1].sign;
            if (winding >= 1) inside.push_back({.low = met[next].z, .high = met[next - 1].z});
        }
        if (inside.empty()) continue;
        rays_.push_back(points[k]);
        intervals_.push_back(std::move(inside));
    }
}

SeenVolumes ToolRays::look(std::span<const Corners> organ_facets) const {
    SeenVolumes lengths;
    const Crossings crossings(rays_, organ_facets);
    for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
        const auto met = crossings.of(ray);
        int winding = 0;
        for (std::size_t k = 0; k < met.size(); ++k) {
            winding += met[k].sign;
            const double high = met[k].z, low = k + 1 < met.size() ? met[k + 1].z : lowest;
            const int excess = winding - static_cast<int>(winding >= 1);
            for (const Interval& within : intervals_[ray]) {
                const double length = std::max(0.0, std::min(high, within.high) - std::max(low, within.low));
                if (winding >= 1) lengths.inside += length;
                lengths.excess += excess * length;
                lengths.ambiguous += std::abs(excess) * length;
            }
        }
    }
    return {lengths.inside * cell_, lengths.excess * cell_, lengths.ambiguous * cell_};
}

}  // namespace trocar
