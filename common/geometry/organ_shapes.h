#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

/// An organ made by formula.
struct OrganShape {
    std::string name;
    std::string summary;  ///< one line
    double default_size;  ///< mm
    /// The mesh with edges of about `edge_mm`, `size_mm` across, centred at the origin. Throws
    /// std::invalid_argument for an edge that is not positive, longer than the shape, or so short that the
    /// mesh would have more than 4 million facets.
    SurfaceMesh (*make)(double edge_mm, double size_mm);
};

/// Every shape of this build, in the order in which they are listed to users.
const std::vector<OrganShape>& all_organ_shapes();

/// The organ that a text such as "sphere@4mm" names: a shape, "@", the length of its edges. Without the "@"
/// part edges are 4 mm. Throws std::invalid_argument, which says what was expected.
Organ make_organ_by_formula(std::string_view formula);

}  // namespace trocar
