#include "common/tool/shape_parts.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace trocar {

void check_length(std::string_view what, double value) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument(fmt::format("{} {} mm: expected a positive length", what, value));
}

void check_angle(std::string_view what, double degrees, double low, double high) {
    if (degrees >= low && degrees <= high) return;
    throw std::invalid_argument(
        fmt::format("{} {} degrees: expected {} to {} degrees", what, degrees, low, high));
}

std::vector<Vec3> ring(int count, double radius, double z) {
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return points;
}

void add_side(SurfaceMesh& mesh, Index a, Index b, Index c, Index d) {
    mesh.facets.push_back({a, b, c});
    mesh.facets.push_back({a, c, d});
}

void add_end(SurfaceMesh& mesh, Index first, Index count, bool towards_handle) {
    for (Index k = 1; k + 1 < count; ++k) {
        const Index low = first + k, high = low + 1;
        mesh.facets.push_back(towards_handle ? Facet{first, low, high} : Facet{first, high, low});
    }
}

}  // namespace trocar
