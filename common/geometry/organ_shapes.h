#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

/// An organ made by formula.
struct OrganShape {
    std::string name;
    std::string summary;   ///< one line
    double default_size;   ///< mm
    double shortest_edge;  ///< of a mesh at the default size, mm; below it lie millions of facets
    double longest_edge;   ///< mm; longer edges would miss the shape
    /// The organ of that name with edges of about `edge_mm`, `size_mm` across, centred at the origin. No
    /// angle of its facets is below 10°, no edge longer than twice or shorter than half of `edge_mm`; a
    /// closed one does not meet itself. The same numbers give the same bits. The edge has to be in the range
    /// above, which grows with the size.
    Organ (*make)(std::string name, double edge_mm, double size_mm);
};

/// Every shape of this build, in the order in which they are listed to users.
const std::vector<OrganShape>& all_organ_shapes();

/// The organ that a text such as "sphere@4mm" names: a shape, "@", the length of its edges. Without the "@"
/// part edges are 4 mm. Throws std::invalid_argument, which says what was expected.
Organ make_organ_by_formula(std::string_view formula);

}  // namespace trocar
