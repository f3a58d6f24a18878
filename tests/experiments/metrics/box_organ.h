#pragma once

#include "common/geometry/organ.h"

namespace trocar {

/// A closed box from `low` to `high` (mm), each side cut into `cells` × `cells` rectangles of two facets.
Organ box_organ(const Vec3& low, const Vec3& high, int cells);

}  // namespace trocar
