#pragma once

#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Points spread evenly over a tool's surface, one per mm² but at least one; always the same for the same
/// mesh. Every facet gets as many as its area says, rounded up or down. Ascending by x.
std::vector<Vec3> tool_points(const SurfaceMesh& tool);

}  // namespace trocar
