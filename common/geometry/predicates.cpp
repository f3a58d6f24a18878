#include "common/geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Whether the segment from `p` to `q`, whose ends lie strictly on opposite sides of the triangle's plane,
/// passes through the triangle: its inside, or an edge listed in `open_edges`.
bool pierces(const Vec3& p, const Vec3& q, const Corners& triangle, const std::array<bool, 3>& open_edges) {
    int side = 0;
    for (int k = 0; k < 3; ++k) {
        const int sign = orientation_sign(p, q, triangle[k], triangle[(k + 1) % 3]);
        if (sign == 0) {
            if (!open_edges[k]) return false;
            continue;
        }
        if (side == 0) side = sign;
        if (sign != side) return false;
    }
    return side != 0;
}

}  // namespace

int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return static_cast<int>(
        CGAL::orientation(exact_point(a), exact_point(b), exact_point(c), exact_point(d)));
}

int turn_sign(const Vec3& a, const Vec3& b, const Vec3& p, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto seen = [&](const Vec3& point) { return Kernel::Point_2(point[u], point[v]); };
    return static_cast<int>(CGAL::orientation(seen(a), seen(b), seen(p)));
}

bool facets_cross(const Corners& organ, const Corners& tool, const std::array<bool, 3>& flat_edges) {
    std::array<int, 3> organ_sides{};
    for (int k = 0; k < 3; ++k) organ_sides[k] = orientation_sign(tool[0], tool[1], tool[2], organ[k]);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if (organ_sides[k] * organ_sides[next] < 0 && pierces(organ[k], organ[next], tool, flat_edges)) {
            return true;
        }
    }
    std::array<int, 3> tool_sides{};
    for (int k = 0; k < 3; ++k) tool_sides[k] = orientation_sign(organ[0], organ[1], organ[2], tool[k]);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if (tool_sides[k] * tool_sides[next] < 0 && pierces(tool[k], tool[next], organ, {})) return true;
    }
    return false;
}

}  // namespace trocar
