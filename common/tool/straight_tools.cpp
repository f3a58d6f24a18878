// Tools with one straight shaft: prisms, flat or pointed, and needles.

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "common/tool/shape_parts.h"
#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

constexpr int needle_sides = 16;

void append(SurfaceMesh& mesh, const std::vector<Vec3>& points) {
    mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
}

/// The sides between the ring of vertices that begins at `low` and the one towards the handle at `high`.
void add_sides(SurfaceMesh& mesh, int sides, Index low, Index high) {
    for (Index k = 0; k < sides; ++k) {
        const Index next = (k + 1) % sides;
        add_side(mesh, low + k, low + next, high + next, high + k);
    }
}

SurfaceMesh flat_mesh(int sides, double radius, double length) {
    SurfaceMesh mesh;
    append(mesh, ring(sides, radius, 0));
    append(mesh, ring(sides, radius, length));
    add_sides(mesh, sides, 0, sides);
    add_end(mesh, 0, sides, false);
    add_end(mesh, sides, sides, true);
    return mesh;
}

SurfaceMesh pointed_mesh(int sides, double radius, double length, double tip_length) {
    SurfaceMesh mesh;
    mesh.positions.emplace_back(0, 0, 0);
    append(mesh, ring(sides, radius, tip_length));
    append(mesh, ring(sides, radius, length));
    for (Index k = 0; k < sides; ++k) mesh.facets.push_back({0, 1 + (k + 1) % sides, 1 + k});
    add_sides(mesh, sides, 1, 1 + sides);
    add_end(mesh, 1 + sides, sides, true);
    return mesh;
}

void check_sides(int sides) {
    if (sides >= fewest_sides && sides <= most_sides) return;
    throw std::invalid_argument(
        fmt::format("a prism of {} sides: expected {} to {}", sides, fewest_sides, most_sides));
}

void check_tip(std::string_view what, double tip_length, double length) {
    if (tip_length < length) return;
    throw std::invalid_argument(fmt::format(
        "{} tip is {} mm long: expected less than its whole length of {} mm", what, tip_length, length));
}

}  // namespace

Tool make_prism(int sides, double radius, double length) {
    check_sides(sides);
    check_length("prism's radius", radius);
    check_length("prism's length", length);
    std::string name = fmt::format("prism-{}", sides);
    if (radius != default_prism_radius || length != default_prism_length) {
        name += fmt::format(" r{} l{}", radius, length);
    }
    return make_tool(std::move(name), flat_mesh(sides, radius, length));
}

Tool make_pointed_prism(int sides, const PointedPrismSize& size) {
    const auto& [radius, length, tip_length] = size;
    check_sides(sides);
    check_length("pointed prism's radius", radius);
    check_length("pointed prism's length", length);
    check_length("pointed prism's tip_length", tip_length);
    check_tip("a pointed prism's", tip_length, length);
    std::string name = fmt::format("pointed-prism-{}", sides);
    constexpr PointedPrismSize usual;
    if (radius != usual.radius || length != usual.length || tip_length != usual.tip_length) {
        name += fmt::format(" r{} l{} t{}", radius, length, tip_length);
    }
    return make_tool(std::move(name), pointed_mesh(sides, radius, length, tip_length));
}

Tool make_needle(const NeedleSize& size) {
    const auto& [radius, length, tip_angle] = size;
    check_length("needle's radius", radius);
    check_length("needle's length", length);
    check_angle("needle's tip_angle", tip_angle, 1, 120);
    const double tip_length = radius / std::tan(tip_angle / 2 * std::numbers::pi / 180);
    check_tip("a needle's", tip_length, length);
    std::string name = "needle";
    constexpr NeedleSize usual;
    if (radius != usual.radius || length != usual.length || tip_angle != usual.tip_angle) {
        name += fmt::format(" r{} l{} a{}", radius, length, tip_angle);
    }
    return make_tool(std::move(name), pointed_mesh(needle_sides, radius, length, tip_length));
}

}  // namespace trocar
