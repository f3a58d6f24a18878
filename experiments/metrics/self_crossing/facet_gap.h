#pragma once

#include "common/geometry/predicates.h"

namespace trocar {

/// @{
/// A width (mm) of the empty slab between two triangles, right whatever the rounding: they are at least this
/// far apart. A slab's normal is tried for every way in which two triangles can be nearest to each other.

/// The widest slab, or the first one that is wider than `enough`; 0 where there is none.
double facet_gap(const Corners& one, const Corners& other, double enough);

/// Whether there is a slab at all. Finds one for any two triangles that are apart, but for rounding.
inline bool shown_apart(const Corners& one, const Corners& other) { return facet_gap(one, other, 0) > 0; }
/// @}

}  // namespace trocar
