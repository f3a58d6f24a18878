#pragma once

#include "common/geometry/facet_tree.h"

namespace trocar {

/// Whether `point` lies strictly inside the closed surface whose facets the tree has, which does not meet
/// itself; exact for these very coordinates.
bool is_inside(const FacetTree& tree, const Vec3& point);

}  // namespace trocar
