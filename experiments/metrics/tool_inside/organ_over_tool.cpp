#include "experiments/metrics/tool_inside/organ_over_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "experiments/metrics/tool_inside/facet_piece.h"

namespace trocar {
namespace {

bool over(const Corners& facet, const Box& box) {
    Box reach = box;
    reach.high.z() = std::numeric_limits<double>::max();
    if (!bounding_box(facet).overlaps(reach)) return false;
    FacetPiece piece(facet);
    piece.cut([&](const Vec3& p) { return p.x() - box.low.x(); });
    piece.cut([&](const Vec3& p) { return box.high.x() - p.x(); });
    piece.cut([&](const Vec3& p) { return p.y() - box.low.y(); });
    piece.cut([&](const Vec3& p) { return box.high.y() - p.y(); });
    return std::ranges::any_of(piece.corners(), [&](const Vec3& p) { return p.z() >= box.low.z(); });
}

/// A point beneath the middle of a sheet with this border, ten times as deep as a square sheet's diagonal:
/// deeper than any tool gets.
Vec3 bottom_of(const std::vector<Vec3>& positions, const std::vector<std::array<Index, 2>>& border) {
    Vec3 middle = Vec3::Zero(), area_vector = Vec3::Zero();
    for (const auto& [from, to] : border) middle += positions[from] / static_cast<double>(border.size());
    for (const auto& [from, to] : border) {
        area_vector += (positions[from] - middle).cross(positions[to] - middle) / 2;
    }
    constexpr double diagonals = 10;
    return middle - diagonals * std::sqrt(2 * area_vector.norm()) * area_vector.stableNormalized();
}

}  // namespace

std::vector<Corners> organ_over_tool(const JudgedState& state) {
    constexpr double rounding = 1e-6;  // mm: far more than the error of a cut
    const Box box = state.tool().box().grown(rounding);
    const std::vector<Vec3>& positions = state.in_tool();
    std::vector<Corners> found;
    const auto add = [&](const Corners& facet) {
        if (over(facet, box)) found.push_back(facet);
    };
    for (const auto& [a, b, c] : state.organ().facets()) add({positions[a], positions[b], positions[c]});
    const auto& border = state.organ().border();
    if (border.empty()) return found;
    const Vec3 bottom = bottom_of(positions, border);
    for (const auto& [from, to] : border) add({positions[to], positions[from], bottom});
    return found;
}

}  // namespace trocar
