#include "tests/benchmarks/bench_tools.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

constexpr int sides = 16;            // of the bar's section
constexpr int bend = 24;             // parts of the half circle
constexpr int point = 4;             // parts of the end that goes up
constexpr int shaft = 4;             // parts of the shaft
constexpr double bar = 2;            // mm, radius of the bar at the shaft
constexpr double turn = 6;           // mm, radius of the half circle along the bar's middle
constexpr double point_length = 10;  // mm
constexpr double shaft_length = 70;  // mm
constexpr double thinning = 0.4;     // of the bar from the shaft to its other end

/// A place on the bar's middle, and the direction across the bar in the plane of the hook.
struct Station {
    Vec3 middle, across;
};

/// From the end of the point to the handle.
std::vector<Station> stations() {
    const double height = turn + bar;  // of the half circle's centre: the bar's lowest point is at 0
    std::vector<Station> all;
    for (int k = 0; k < point; ++k) {
        const double up = point_length * (point - k) / point;
        all.push_back({{turn, 0, height + up}, Vec3::UnitX()});
    }
    for (int k = 0; k <= bend; ++k) {
        const double angle = std::numbers::pi * k / bend;
        const Vec3 out(std::cos(angle), 0, -std::sin(angle));
        all.push_back({Vec3(0, 0, height) + turn * out, out});
    }
    for (int k = 1; k <= shaft; ++k) {
        all.push_back({{-turn, 0, height + shaft_length * k / shaft}, -Vec3::UnitX()});
    }
    return all;
}

SurfaceMesh hook_mesh() {
    SurfaceMesh mesh;
    const std::vector<Station> along = stations();
    for (std::size_t s = 0; s < along.size(); ++s) {
        const double part = static_cast<double>(s) / static_cast<double>(along.size() - 1);
        const double radius = bar * (1 - thinning * (1 - part));
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            mesh.positions.emplace_back(along[s].middle + radius * (std::cos(angle) * along[s].across +
                                                                    std::sin(angle) * Vec3::UnitY()));
        }
    }
    const auto rings = static_cast<Index>(along.size());
    for (Index s = 0; s + 1 < rings; ++s) {
        for (Index k = 0; k < sides; ++k) {
            const Index a = s * sides + k, b = s * sides + (k + 1) % sides, c = a + sides, d = b + sides;
            mesh.facets.push_back({a, c, b});
            mesh.facets.push_back({b, c, d});
        }
    }
    const Index last = (rings - 1) * sides;
    for (Index k = 1; k + 1 < sides; ++k) {
        mesh.facets.push_back({0, k, k + 1});
        mesh.facets.push_back({last, last + k + 1, last + k});
    }
    return mesh;
}

}  // namespace

const std::array<BenchTool, 3> bench_tools = {{
    {.name = "prism-12", .make = [] { return make_tool_by_formula("prism-12"); }},
    {.name = "grasper", .make = [] { return make_tool_by_formula("grasper"); }},
    {.name = "curved-hook", .make = [] { return make_tool("curved-hook", hook_mesh()); }},
}};

}  // namespace trocar
