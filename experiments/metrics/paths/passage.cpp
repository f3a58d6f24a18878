#include "experiments/metrics/paths/passage.h"

#include <algorithm>
#include <span>
#include <vector>

namespace trocar {
namespace {

constexpr double opposite_sides = -0.7071;  // the normals' dot product is less
constexpr double least_passage = 1e-9;      // mm

/// Where a straight way meets a facet.
struct Meeting {
    double distance;  ///< from its beginning, mm
    Vec3 normal;      ///< outer, of the facet
};

/// Whether the line through `from` and `to` meets the triangle or its border; exact.
bool line_meets(const Vec3& from, const Vec3& to, const Corners& triangle) {
    bool left = false, right = false;
    for (int k = 0; k < 3; ++k) {
        const int side = orientation_sign(from, to, triangle[k], triangle[(k + 1) % 3]);
        left = left || side > 0;
        right = right || side < 0;
    }
    return !(left && right);
}

/// In the order of the way. Facets along which it slides are left out: it meets the others around them.
std::vector<Meeting> meetings(const JudgedTool& tool, const Vec3& from, const Vec3& to) {
    std::vector<Meeting> met;
    Box box;
    box.add(from);
    box.add(to);
    const auto& positions = tool.mesh().positions;
    for (const Index facet : tool.surface().facets_near(box)) {
        const auto& [a, b, c] = tool.mesh().facets[facet];
        const Corners corners = {positions[a], positions[b], positions[c]};
        const int before = orientation_sign(corners[0], corners[1], corners[2], from);
        const int after = orientation_sign(corners[0], corners[1], corners[2], to);
        if (before == after || !line_meets(from, to, corners)) continue;
        const Vec3 normal = facet_normal(positions, tool.mesh().facets[facet]);
        const double height_before = std::abs(normal.dot(from - corners[0]));
        const double height_after = std::abs(normal.dot(to - corners[0]));
        const double part = before == 0 ? 0 : after == 0 ? 1 : height_before / (height_before + height_after);
        met.push_back({part * (to - from).norm(), normal});
    }
    std::ranges::sort(met, {}, &Meeting::distance);
    return met;
}

/// The normal that points most along the direction.
const Vec3& most_along(const Vec3& direction, std::span<const Meeting> met) {
    return std::ranges::max_element(met, {}, [&](const Meeting& one) { return one.normal.dot(direction); })
        ->normal;
}

bool well_inside(const JudgedTool& tool, const Vec3& point) {
    return tool.contains(point) && tool.surface().distance(point) > least_passage;
}

}  // namespace

void follow(const JudgedTool& tool, const Vec3& from, const Vec3& to, Passage& passage) {
    const std::vector<Meeting> met = meetings(tool, from, to);
    if (met.empty()) return;
    const Vec3 direction = (to - from).normalized();
    bool inside = tool.contains(from);
    for (auto begin = met.begin(); begin != met.end();) {
        auto end = begin + 1;
        while (end != met.end() && end->distance - (end - 1)->distance <= least_passage) ++end;
        const bool inside_next =
            end == met.end()
                ? tool.contains(to)
                : well_inside(tool, from + ((end - 1)->distance + end->distance) / 2 * direction);
        if (inside_next && !inside) {
            passage.entry = most_along(-direction, {begin, end});
            passage.went_in = true;
        }
        if (inside && !inside_next) {
            passage.crossed =
                passage.entry && passage.entry->dot(most_along(direction, {begin, end})) < opposite_sides;
            passage.entry.reset();
        }
        inside = inside_next;
        begin = end;
    }
}

}  // namespace trocar
