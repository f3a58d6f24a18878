#pragma once

#include "tests/strategies/contract_scene.h"

namespace trocar::contract {

/// One collided vertex, number 0, at `inside` of a tool, with the facets of a pyramid around it: the corners
/// of the base lie around it counter-clockwise seen from outside, facet k between corners k and k + 1. The
/// tool stands upright, tip at the origin; the material at the vertex moved by `motion` (mm).
Scene single_vertex(const Vec3& inside, const std::vector<Vec3>& corners, const Vec3& motion);

/// Corners of a square in the plane of the vertex: every facet's normal is +z.
std::vector<Vec3> flat_base(const Vec3& vertex);

}  // namespace trocar::contract
