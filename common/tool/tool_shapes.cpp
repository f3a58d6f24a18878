#include "common/tool/tool_shapes.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "common/nearest_name.h"

namespace trocar {
namespace {

constexpr int fewest_sides = 3;
constexpr int most_sides = 64;
constexpr std::string_view prism_prefix = "prism-";

void check_length(const char* what, double value) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument(fmt::format("prism's {} {} mm: expected a positive length", what, value));
}

// Vertices 0 to sides − 1 are the tip end's corners, counter-clockwise seen from the handle; the handle end's
// follow in the same order.
SurfaceMesh prism_mesh(Index sides, double radius, double length) {
    SurfaceMesh mesh;
    for (const double z : {0.0, length}) {
        for (Index corner = 0; corner < sides; ++corner) {
            const double angle = 2 * std::numbers::pi * corner / sides;
            mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    }
    for (Index corner = 0; corner < sides; ++corner) {
        const Index next = (corner + 1) % sides;
        mesh.facets.push_back({corner, next, sides + next});
        mesh.facets.push_back({corner, sides + next, sides + corner});
    }
    for (Index corner = 1; corner + 1 < sides; ++corner) {
        mesh.facets.push_back({0, corner + 1, corner});
        mesh.facets.push_back({sides, sides + corner, sides + corner + 1});
    }
    return mesh;
}

}  // namespace

const std::vector<ToolShape>& all_tool_shapes() {
    static const std::vector<ToolShape> shapes = {
        {"prism-N", "a straight prism of N sides (3 to 64), 4 mm in radius, 80 mm long, with flat ends"},
    };
    return shapes;
}

Tool make_tool_by_formula(std::string_view formula) {
    if (!formula.starts_with(prism_prefix)) {
        std::vector<std::string> names;
        for (const ToolShape& shape : all_tool_shapes()) names.push_back(shape.name);
        throw std::invalid_argument(unknown_name("tool", formula, names));
    }
    const std::string_view text = formula.substr(prism_prefix.size());
    int sides = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), sides);
    if (error != std::errc() || end != text.end() || sides < fewest_sides || sides > most_sides) {
        throw std::invalid_argument(
            fmt::format("tool \"{}\": expected prism-N, N a whole number from {} to {}, such as prism-12",
                        formula, fewest_sides, most_sides));
    }
    return make_prism(sides);
}

Tool make_prism(int sides, double radius, double length) {
    if (sides < fewest_sides || sides > most_sides) {
        throw std::invalid_argument(
            fmt::format("a prism of {} sides: expected {} to {}", sides, fewest_sides, most_sides));
    }
    check_length("radius", radius);
    check_length("length", length);
    std::string name = fmt::format("prism-{}", sides);
    if (radius != default_prism_radius || length != default_prism_length) {
        name += fmt::format(" r{} l{}", radius, length);
    }
    return make_tool(std::move(name), prism_mesh(sides, radius, length));
}

}  // namespace trocar
