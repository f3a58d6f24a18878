#include "experiments/metrics/tool_inside/winding_integral.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "experiments/metrics/tool_inside/facet_piece.h"

namespace trocar {

WindingIntegral::WindingIntegral(const SurfaceMesh& tool) : base_(bounding_box(tool.positions).low.z()) {
    constexpr double upright = 1e-12;  // mm² of shadow: nothing times any length
    for (const auto& [a, b, c] : tool.facets) {
        Corners corners{tool.positions[a], tool.positions[b], tool.positions[c]};
        Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        if (std::abs(normal.z()) < upright) continue;
        const int sign = normal.z() > 0 ? 1 : -1;
        if (sign < 0) std::swap(corners[1], corners[2]);
        const double z_x = -normal.x() / normal.z(), z_y = -normal.y() / normal.z();
        const double z = corners[0].z() - base_ - z_x * corners[0].x() - z_y * corners[0].y();
        facets_.push_back({corners, sign, bounding_box(corners), z, z_x, z_y});
    }
}

double WindingIntegral::pair(const Corners& organ_facet, const Facet& tool_facet, double base) {
    FacetPiece piece(organ_facet);
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = tool_facet.corners[k], &b = tool_facet.corners[(k + 1) % 3];
        piece.cut([&](const Vec3& p) {
            return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
        });
    }
    const auto organ_height = [&](const Vec3& p) { return p.z() - base; };
    const auto organ_above = [&](const Vec3& p) {
        return p.z() - base - (tool_facet.z + tool_facet.z_x * p.x() + tool_facet.z_y * p.y());
    };
    const double of_organ = piece.integral(organ_height);
    piece.cut(organ_above);
    return tool_facet.sign * (of_organ - piece.integral(organ_above));
}

double WindingIntegral::over_tool(std::span<const Corners> organ_facets) const {
    double sum = 0;
    for (const Corners& corners : organ_facets) {
        Box shadow = bounding_box(corners);
        for (const Facet& facet : facets_) {
            shadow.low.z() = facet.box.low.z();
            shadow.high.z() = facet.box.high.z();
            if (shadow.overlaps(facet.box)) sum += pair(corners, facet, base_);
        }
    }
    return sum;
}

}  // namespace trocar
