#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/geometry/predicates.h"

namespace trocar {

/// A column, the line along z through a point, that goes through a facet.
struct ColumnHit {
    Index column;  ///< number of its point
    int sign;      ///< +1 where the facet faces +z, −1 where it faces −z
};

/// Puts into `hits` the columns that go through the facet. Exact: a column counts as moved by (ε, ε²) for an
/// infinitesimal ε > 0, so that none goes through an edge or a corner, and one that does meet an edge shared
/// by two facets goes through exactly one of them, or through both where the surface folds over there. No
/// column goes through a facet that stands upright.
/// @param points of the columns, ascending by x
void find_columns(std::span<const Vec3> points, const Corners& facet, std::vector<ColumnHit>& hits);

/// Where a column goes through a facet.
struct Crossing {
    double z;  ///< mm
    int sign;  ///< what going down through it adds to the surface's winding number
};

/// All crossings of columns with a surface.
class Crossings {
  public:
    /// @param points of the columns, ascending by x
    Crossings(std::span<const Vec3> points, std::span<const Corners> facets);

    /// Those of one column, from the highest down.
    [[nodiscard]] std::span<const Crossing> of(std::size_t column) const {
        return {crossings_.data() + offsets_[column], crossings_.data() + offsets_[column + 1]};
    }

  private:
    std::vector<Crossing> crossings_;
    std::vector<std::size_t> offsets_;  // of each column's first crossing; one more at the end
};

}  // namespace trocar
