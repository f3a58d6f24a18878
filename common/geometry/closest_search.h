#pragma once

#include "common/geometry/facet_tree.h"

namespace trocar {

/// The facet that is nearest to a point.
struct ClosestFacet {
    Vec3 position;  ///< its point that is closest
    Index facet;
};

/// The closest facet of a tree; of facets whose distances differ by `rounding` (mm) or less from the least
/// that of the lowest number.
ClosestFacet closest_facet(const FacetTree& tree, const Vec3& point, double rounding);

}  // namespace trocar
