#pragma once

#include <string_view>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

// What the formulas of tools share.

inline constexpr int fewest_sides = 3;  ///< of a prism
inline constexpr int most_sides = 64;   ///< of a prism

/// Throws std::invalid_argument unless `value` is a positive, finite length (mm). `what` is such as
/// "prism's radius".
void check_length(std::string_view what, double value);

/// Throws std::invalid_argument unless low <= degrees <= high.
void check_angle(std::string_view what, double degrees, double low, double high);

/// `count` points on a circle around the z axis at height `z`, counter-clockwise seen from the handle, the
/// first at +x.
std::vector<Vec3> ring(int count, double radius, double z);

/// Adds the two facets of the flat side with these corners, counter-clockwise seen from outside.
void add_side(SurfaceMesh& mesh, Index a, Index b, Index c, Index d);

/// Adds the facets of a flat convex polygon with the vertices `first` to `first + count - 1`, which run
/// counter-clockwise seen from the handle; `towards_handle` says on which side of it the outside is.
void add_end(SurfaceMesh& mesh, Index first, Index count, bool towards_handle);

}  // namespace trocar
