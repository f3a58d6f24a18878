#include "experiments/scenes/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "experiments/scenes/draws.h"

namespace trocar {
namespace {

constexpr std::uint64_t most_draws = 10'000;

/// A point of the organ at rest and the facet it lies on.
struct EntryPoint {
    Vec3 position;
    std::size_t facet;
};

/// A point drawn uniformly by area. @param areas_up_to sum of the areas of the facets up to each
EntryPoint point_by_area(const Organ& organ, const std::vector<double>& areas_up_to,
                         const std::array<double, 4>& uniform) {
    const double at = uniform[0] * areas_up_to.back();
    const auto found = std::ranges::upper_bound(areas_up_to, at);
    const auto facet = std::min<std::size_t>(found - areas_up_to.begin(), areas_up_to.size() - 1);
    const auto [a, b, c] = organ.rest.facets[facet];
    // Uniform over the triangle: the square root makes up for its narrowing towards a (Osada et al. 2002).
    const double along = std::sqrt(uniform[1]), across = uniform[2];
    const auto& p = organ.rest.positions;
    return {(1 - along) * p[a] + along * (1 - across) * p[b] + along * across * p[c], facet};
}

/// Mean outer normal, by area, of the facets whose centre is within `radius` of the point.
Vec3 mean_normal(const Organ& organ, const EntryPoint& point, double radius) {
    Vec3 sum = organ.rest_areas[point.facet] * organ.rest_normals[point.facet];
    for (std::size_t f = 0; f < organ.rest.facets.size(); ++f) {
        const auto [a, b, c] = organ.rest.facets[f];
        const auto& p = organ.rest.positions;
        const Vec3 centre = (p[a] + p[b] + p[c]) / 3;
        if (f != point.facet && (centre - point.position).norm() <= radius) {
            sum += organ.rest_areas[f] * organ.rest_normals[f];
        }
    }
    return sum.normalized();
}

/// Unit vector orthogonal to `normal`, turned about it by `turn` of a full circle.
Vec3 tangent_of(const Vec3& normal, double turn) {
    int least = 0;
    normal.cwiseAbs().minCoeff(&least);
    const Vec3 first = normal.cross(Vec3::Unit(least)).normalized();
    const double angle = 2 * std::numbers::pi * turn;
    return std::cos(angle) * first + std::sin(angle) * normal.cross(first);
}

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
    const double along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (point - (a + along * (b - a))).norm();
}

bool near_boundary(const Organ& organ, const Vec3& point, double distance) {
    const Adjacency& adjacency = organ.adjacency;
    return !adjacency.closed() && std::ranges::any_of(adjacency.edges(), [&](const Edge& edge) {
        // Edges between two boundary vertices: the boundary's own, and at a corner of the sheet its
        // neighbour.
        return adjacency.on_boundary(edge[0]) && adjacency.on_boundary(edge[1]) &&
               distance_to_segment(point, organ.rest.positions[edge[0]], organ.rest.positions[edge[1]]) <
                   distance;
    });
}

}  // namespace

Placement place(const SceneInputs& inputs, double depth) {
    const Organ& organ = inputs.organ;
    const double reach = 2 * inputs.tool.radius;
    std::vector<double> areas_up_to(organ.rest_areas.size());
    std::inclusive_scan(organ.rest_areas.begin(), organ.rest_areas.end(), areas_up_to.begin());

    for (std::uint64_t k = 0; k < most_draws; ++k) {
        const EntryPoint point = point_by_area(organ, areas_up_to, draw(inputs.seed, 2 * k + 1));
        if (near_boundary(organ, point.position, reach)) continue;
        const Vec3 normal = mean_normal(organ, point, reach);
        const double skip = 1e-6 * reach;  // the surface at the point itself
        const auto through = inputs.organ_queries.distance_to_exit(point.position, -normal, skip);
        if (through && *through < 2 * depth) continue;
        const auto free = draw(inputs.seed, 0);
        return {.entry = point.position,
                .normal = normal,
                .tangent = tangent_of(normal, free[0]),
                .phase = free[1]};
    }
    throw PlacementError(
        fmt::format("seed {}: none of {} points drawn on organ \"{}\" is at least {} mm from a boundary and "
                    "{} mm thick; use a "
                    "larger organ (its \"size\") or a slimmer tool",
                    inputs.seed, most_draws, organ.name, reach, 2 * depth));
}

Pose upright_pose(const Placement& placement, const Vec3& tip) {
    Pose pose;
    pose.rotation.col(0) = placement.tangent;
    pose.rotation.col(1) = placement.normal.cross(placement.tangent);
    pose.rotation.col(2) = placement.normal;
    pose.position = tip;
    return pose;
}

}  // namespace trocar
