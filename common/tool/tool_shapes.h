#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/tool/tool.h"

namespace trocar {

/// A kind of tool made by formula.
struct ToolShape {
    std::string name;     ///< as users write it, with N for a number
    std::string summary;  ///< one line
};

/// Every kind of this build, in the order in which they are listed to users.
const std::vector<ToolShape>& all_tool_shapes();

/// The tool that a text such as "prism-12" names. Throws std::invalid_argument, which says what was expected.
Tool make_tool_by_formula(std::string_view formula);

inline constexpr double default_prism_radius = 4;   ///< mm
inline constexpr double default_prism_length = 80;  ///< mm

/// A straight prism with flat ends: its tip end is at z = 0, its corners are on a circle around +z. Named
/// like "prism-12", or "prism-12 r5 l80" when radius or length is not the default one. The two facets of a
/// side are exactly coplanar, and so are those of an end.
/// @param sides 3 to 64
/// @param radius of the circle, mm
/// @param length along the axis, mm
Tool make_prism(int sides, double radius = default_prism_radius, double length = default_prism_length);

}  // namespace trocar
