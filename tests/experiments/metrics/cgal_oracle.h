#pragma once

#include "common/geometry/predicates.h"
#include "experiments/metrics/self_crossing/intersecting_facets.h"

namespace trocar::testing_support {

/// CGAL's self_intersections of the whole mesh, less what it says of single facets; ascending.
std::vector<FacetPair> cgal_self_intersections(const SurfaceMesh& mesh);

/// Whether two triangles meet, if only in a point; exact.
bool cgal_triangles_meet(const Corners& one, const Corners& other);

/// Distance of two triangles that do not meet, mm.
double cgal_triangle_distance(const Corners& one, const Corners& other);

}  // namespace trocar::testing_support
