#pragma once

#include <limits>

#include "common/geometry/predicates.h"

namespace trocar {

/// Closest point of a triangle, by the regions of its corners, edges and inside (Ericson, "Real-Time
/// Collision Detection", 2005, section 5.1.5).
Vec3 closest_on_triangle(const Vec3& point, const Corners& triangle);

/// From `begin` to `end`; a fresh one is empty.
struct Interval {
    double begin = std::numeric_limits<double>::infinity();
    double end = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const { return !(begin < end); }
};

/// The t at which origin + t direction is nearer to the triangle than `reach` (mm). It is one interval, since
/// the distance to a convex set along a line is convex: from the first to the last t of the slab over the
/// triangle, the cylinders around its edges and the balls around its corners. @param direction of unit length
Interval stretch_near(const Vec3& origin, const Vec3& direction, const Corners& triangle, double reach);

}  // namespace trocar
