#pragma once

#include <span>
#include <vector>

#include "common/geometry/vector.h"

namespace trocar {

/// A triangle surface: vertex positions (mm) and facets that index them.
struct SurfaceMesh {
    std::vector<Vec3> positions;
    std::vector<Facet> facets;
};

/// The smallest axis-aligned box around `positions`; empty when there are none.
Box bounding_box(std::span<const Vec3> positions);

/// Half the cross product of a facet's edges (mm²): its direction is the facet's outer normal, its length
/// the facet's area.
Vec3 facet_area_vector(std::span<const Vec3> positions, const Facet& facet);

/// The facet's outer unit normal; zero for a facet without area.
Vec3 facet_normal(std::span<const Vec3> positions, const Facet& facet);

/// Area of each facet in mm², in facet order.
std::vector<double> facet_areas(const SurfaceMesh& mesh);

/// Volume enclosed by a closed mesh in mm³: positive when its facets are counter-clockwise seen from outside.
double signed_volume(const SurfaceMesh& mesh);

}  // namespace trocar
