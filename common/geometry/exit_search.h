#pragma once

#include "common/geometry/facet_tree.h"

namespace trocar {

/// See Solid::exit_distance.
/// @param rounding error of a distance, mm
double exit_distance(const FacetTree& tree, const Vec3& point, const Vec3& direction, double clearance,
                     double rounding);

}  // namespace trocar
