#pragma once

#include <array>

#include "common/geometry/vector.h"

namespace trocar {

/// Sign of the volume of the tetrahedron (a, b, c, d), exact for these coordinates: +1 when d lies above the
/// plane of a, b, c (on the side from which they run counter-clockwise), 0 on it, −1 below.
int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the area of the triangle (a, b, p) as it is seen along an axis, exact for these coordinates: +1
/// when the three run counter-clockwise for an eye on the axis's positive side.
/// @param axis 0, 1 or 2
int turn_sign(const Vec3& a, const Vec3& b, const Vec3& p, int axis);

/// The corners of a facet, counter-clockwise seen from outside.
using Corners = std::array<Vec3, 3>;

/// Whether triangle `organ` properly crosses triangle `tool`, by exact orientation signs: an edge of one runs
/// from strictly one side of the other's plane to strictly the other side and pierces the other's inside.
/// Touching (a corner or an edge that only meets the other) is not crossing.
/// @param flat_edges for edge k of `tool` (from corner k to corner k + 1): whether the tool's surface goes on
///   flat beyond it, so that piercing that edge itself is piercing the surface.
bool facets_cross(const Corners& organ, const Corners& tool, const std::array<bool, 3>& flat_edges = {});

}  // namespace trocar
