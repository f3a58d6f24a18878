#pragma once

#include <optional>

#include "common/geometry/organ.h"

namespace trocar {

/// Mean outer normal (unit), by area, of the facets of the organ at rest that are connected to `facet` by
/// facets whose centre is within `radius` (mm) of `point`: those of an opposite wall do not count, however
/// near it is. None where they face every way alike, as the whole of an organ smaller than `radius` does.
std::optional<Vec3> mean_normal(const Organ& organ, const Vec3& point, Index facet, double radius);

}  // namespace trocar
