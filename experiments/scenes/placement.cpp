#include "experiments/scenes/placement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "experiments/scenes/distances.h"
#include "experiments/scenes/draws.h"
#include "experiments/scenes/mean_normal.h"
#include "experiments/scenes/surface_way.h"
#include "experiments/scenes/window.h"

namespace trocar {
namespace {

constexpr std::uint64_t most_draws = 10'000;

/// A tip that goes along the surface is at least this part of its depth from it. Where the surface is bent or
/// rough within two tool radii the mean normal does not point straight out of it; in the middle of a rim as
/// wide as the tool a tip "below" the surface is as near to the walls, or outside.
constexpr double least_depth = 0.5;

/// A point of the organ at rest and the facet it lies on.
struct EntryPoint {
    Vec3 position;
    Index facet;
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
    return {(1 - along) * p[a] + along * (1 - across) * p[b] + along * across * p[c],
            static_cast<Index>(facet)};
}

/// The point of a sheet over a point drawn uniformly from its outline: the same place for every sheet of that
/// outline, whatever its relief and mesh.
EntryPoint point_over_outline(const Organ& organ, const Outline& outline,
                              const std::array<double, 4>& uniform) {
    const auto& p = organ.rest.positions;
    const double x = (2 * uniform[0] - 1) * outline.half_x;
    const double y = (2 * uniform[1] - 1) * outline.half_y;
    EntryPoint best{.position = Vec3::Zero(), .facet = 0};
    double best_inside = -std::numeric_limits<double>::infinity();
    for (std::size_t facet = 0; facet < organ.rest.facets.size(); ++facet) {
        const auto [a, b, c] = organ.rest.facets[facet];
        const auto twice_area = [&](const Vec3& from, const Vec3& to) {
            return (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
        };
        const Vec3 parts(twice_area(p[b], p[c]), twice_area(p[c], p[a]), twice_area(p[a], p[b]));
        // On an edge between two facets rounding may put the point just outside both: the nearest one wins.
        const double inside = parts.minCoeff() / parts.sum();
        if (!(inside > best_inside)) continue;
        best_inside = inside;
        const Vec3 share = parts / parts.sum();
        best = {share[0] * p[a] + share[1] * p[b] + share[2] * p[c], static_cast<Index>(facet)};
    }
    return best;
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

/// Whether the way from `from` to `to` comes nearer than `distance` to the organ's boundary.
bool way_near_boundary(const Organ& organ, const Vec3& from, const Vec3& to, double distance) {
    if (organ.adjacency.closed()) return false;
    const auto parts = static_cast<int>(std::ceil(4 * (to - from).norm() / distance));
    for (int k = 0; k <= parts; ++k) {
        const double part = parts == 0 ? 0 : static_cast<double>(k) / parts;
        if (near_boundary(organ, from + part * (to - from), distance)) return true;
    }
    return false;
}

/// Whether the surface is thick enough, or thin enough, beneath a point of it.
bool thick_as_asked(const SceneInputs& inputs, const PlacementRule& rule, const Vec3& point,
                    const Vec3& normal) {
    const double skip = 2e-6 * inputs.tool.radius;  // the surface at the point itself
    const auto through = inputs.organ_queries.distance_to_exit(point, -normal, skip);
    return (through && *through < 2 * rule.depth) == rule.thin;
}

/// Whether the tool can be 3 mm over each of these poses: not where it would stand in an opposite wall, as in
/// a tube.
bool clear_of_organ(const SceneInputs& inputs, std::vector<Pose> poses) {
    for (Pose& pose : poses) pose.position += scenes::clear * pose.rotation.col(2);
    return std::ranges::none_of(window_of(inputs, poses), std::identity());
}

/// Whether a tool can go by that stands `rule.depth` below this point of the surface, upright on it.
bool can_go_by(const SceneInputs& inputs, const PlacementRule& rule, const Pose& on_surface) {
    const Vec3& point = on_surface.position;
    const Vec3 normal = on_surface.rotation.col(2);
    return !near_boundary(inputs.organ, point, 2 * inputs.tool.radius) &&
           thick_as_asked(inputs, rule, point, normal) &&
           inputs.organ_queries.distance(point - rule.depth * normal) >= least_depth * rule.depth;
}

/// The poses on the surface of a tool that goes along it as the rule says, the entry point first. None where
/// it cannot.
std::optional<std::vector<Pose>> stations(const SceneInputs& inputs, const PlacementRule& rule,
                                          const Placement& at) {
    const Pose entry = upright_pose(at, at.entry);
    if (rule.along == 0) return std::vector{entry};
    auto way = surface_way(inputs, entry, rule.along);
    if (!way) return std::nullopt;
    way->insert(way->begin(), entry);
    const bool suited =
        std::ranges::all_of(*way, [&](const Pose& pose) { return can_go_by(inputs, rule, pose); });
    return suited ? way : std::nullopt;
}

std::string no_place(const SceneInputs& inputs, const PlacementRule& rule) {
    const std::string inland = inputs.organ.adjacency.closed()
                                   ? ""
                                   : fmt::format("{:.4g} mm from the boundary, ", 2 * inputs.tool.radius);
    const std::string wall = rule.thin ? fmt::format("opposite a wall nearer than {:.4g} mm", 2 * rule.depth)
                                       : fmt::format("at least {:.4g} mm thick", 2 * rule.depth);
    const std::string along =
        rule.along == 0 ? "" : fmt::format(", for {:.4g} mm along the surface", rule.along);
    const std::string remedy = rule.thin ? "a thinner organ (tube, cleft, or a smaller \"size\")"
                                         : "a larger organ (its \"size\") or a slimmer tool";
    return fmt::format(
        "seed {}: none of {} points drawn on organ \"{}\" is {}{} and free for the tool to come in{}; use {}",
        inputs.seed, most_draws, inputs.organ.name, inland, wall, along, remedy);
}

}  // namespace

Placement place(const SceneInputs& inputs, const PlacementRule& rule) {
    const Organ& organ = inputs.organ;
    const double reach = 2 * inputs.tool.radius;
    const auto free = draw(inputs.seed, 0);
    std::vector<double> areas_up_to(organ.rest_areas.size());
    std::inclusive_scan(organ.rest_areas.begin(), organ.rest_areas.end(), areas_up_to.begin());

    for (std::uint64_t k = 0; k < most_draws; ++k) {
        const auto uniform = draw(inputs.seed, 2 * k + 1);
        const EntryPoint point = organ.outline ? point_over_outline(organ, *organ.outline, uniform)
                                               : point_by_area(organ, areas_up_to, uniform);
        const Vec3& entry = point.position;
        if (way_near_boundary(organ, entry, entry, reach)) continue;
        const auto mean = mean_normal(organ, entry, point.facet, reach);
        if (!mean) continue;
        const Vec3& normal = *mean;
        const Vec3 tangent = tangent_of(normal, free[0]);
        if (way_near_boundary(organ, entry, entry + rule.aside * tangent, reach)) continue;
        if (!thick_as_asked(inputs, rule, entry, normal)) continue;
        const Placement placement{.entry = entry, .normal = normal, .tangent = tangent, .phase = free[1]};
        const auto way = stations(inputs, rule, placement);
        if (way && clear_of_organ(inputs, *way)) return placement;
    }
    throw PlacementError(no_place(inputs, rule));
}

Pose upright_pose(const Placement& placement, const Vec3& tip) {
    Pose pose;
    pose.rotation.col(0) = placement.tangent;
    pose.rotation.col(1) = placement.normal.cross(placement.tangent);
    pose.rotation.col(2) = placement.normal;
    pose.position = tip;
    return pose;
}

std::string unsuited(const SceneEntry& scene, SceneInputs inputs) {
    std::string reason;
    for (int attempt = 0; attempt < 2; ++attempt, ++inputs.seed) {
        try {
            (void)scene.place(inputs);
            return {};
        } catch (const PlacementError& error) {
            if (reason.empty()) reason = error.what();
        }
    }
    return reason;
}

}  // namespace trocar
