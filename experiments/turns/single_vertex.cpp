#include "experiments/turns/single_vertex.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "experiments/scenes/draws.h"

namespace trocar::turns {
namespace {

// Which draw of the seed's stream is for what.
constexpr std::uint64_t draw_patch = 0, draw_place = 1, draw_motion = 2, draw_line = 3, draw_corners = 4;

constexpr int fewest_facets = 5, most_facets = 7;
constexpr double shortest_edge = 2, longest_edge = 5;  // mm
constexpr double steepest = 75;                        // degrees
constexpr double jitter = 0.6;                         // of a corner's direction, as a part of the angle
                                                       // between corners: they stay in order
constexpr double furthest_from_axis = 3.5;             // mm
constexpr double lowest = 0.3, highest = 12;           // above the flat end, mm

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double between(double low, double high, double uniform) { return low + (high - low) * uniform; }

/// Unit vector, uniform over the sphere (Archimedes: its z is uniform).
Vec3 direction(double uniform, double other_uniform) {
    const double z = between(-1, 1, uniform), across = std::sqrt(1 - z * z);
    const double angle = 2 * std::numbers::pi * other_uniform;
    return {across * std::cos(angle), across * std::sin(angle), z};
}

/// The unit vector across `normal` at this angle (radians) around it.
Vec3 across(const Vec3& normal, double angle) {
    const Vec3 first = normal.unitOrthogonal();
    return std::cos(angle) * first + std::sin(angle) * normal.cross(first);
}

Vec3 draw_inside_tool(std::uint64_t seed) {
    const auto uniform = draw(seed, draw_place);
    const double distance = furthest_from_axis * std::sqrt(uniform[0]);
    const double angle = 2 * std::numbers::pi * uniform[1];
    return {distance * std::cos(angle), distance * std::sin(angle), between(lowest, highest, uniform[2])};
}

/// A patch that rises over every point of a plane at most once: seen along the plane's normal the corners go
/// counter-clockwise around the vertex, by less than half a turn from one to the next.
SurfaceMesh draw_patch_around(const Vec3& place, std::uint64_t seed) {
    const auto uniform = draw(seed, draw_patch);
    const Vec3 normal = direction(uniform[0], uniform[1]);
    const auto count = fewest_facets + static_cast<Index>((most_facets - fewest_facets + 1) * uniform[2]);
    SurfaceMesh patch{.positions = {place}, .facets = {}};
    for (Index k = 0; k < count; ++k) {
        const auto of_corner = draw(seed, draw_corners + static_cast<std::uint64_t>(k));
        const double turned = k + jitter * (of_corner[0] - 0.5) + uniform[3];
        const double rise = radians(between(-steepest, steepest, of_corner[1]));
        const double length = between(shortest_edge, longest_edge, of_corner[2]);
        const Vec3 level = across(normal, 2 * std::numbers::pi * turned / count);
        patch.positions.emplace_back(place + length * (std::cos(rise) * level + std::sin(rise) * normal));
        patch.facets.push_back({0, k + 1, (k + 1) % count + 1});
    }
    return patch;
}

}  // namespace

SingleVertex draw_single_vertex(std::shared_ptr<const Tool> tool, std::uint64_t seed) {
    const auto of_motion = draw(seed, draw_motion), of_line = draw(seed, draw_line);
    const Vec3 motion = direction(of_motion[0], of_motion[1]);
    SingleVertex vertex{.tool = std::move(tool),
                        .organ = make_organ("vertex", draw_patch_around(draw_inside_tool(seed), seed)),
                        .first_motion = motion,
                        .first_side = across(motion, 2 * std::numbers::pi * of_motion[2]),
                        .line = direction(of_line[0], of_line[1]),
                        .numbers = {},
                        .velocities = {}};
    vertex.numbers.resize(vertex.organ.rest.positions.size());
    std::iota(vertex.numbers.begin(), vertex.numbers.end(), 0);
    vertex.velocities.assign(vertex.numbers.size(), Vec3::Zero());
    return vertex;
}

}  // namespace trocar::turns
