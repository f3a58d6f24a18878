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

// All shapes have their tip at the origin, +z from there to the handle, flat ends, and flat sides whose
// facets are exactly coplanar. Names state the parameters when one of them is not the default, as in "prism-6
// r5 l80". All throw std::invalid_argument for a parameter out of range.

inline constexpr int fewest_sides = 3;  ///< of a prism
inline constexpr int most_sides = 64;   ///< of a prism

inline constexpr double default_prism_radius = 4;   ///< mm
inline constexpr double default_prism_length = 80;  ///< mm

/// A straight prism with flat ends: its tip end is at z = 0, its corners are on a circle around +z.
/// @param sides fewest_sides to most_sides
/// @param radius of the circle, mm
/// @param length along the axis, mm
Tool make_prism(int sides, double radius = default_prism_radius, double length = default_prism_length);

/// Of make_pointed_prism.
struct PointedPrismSize {
    double radius = 4;      ///< of the circle around the corners, mm
    double length = 80;     ///< with the tip, mm
    double tip_length = 8;  ///< of the pyramid at the tip, mm; less than `length`
};

/// A prism whose tip is a pyramid. Named like "pointed-prism-12", or "pointed-prism-12 r4 l80 t12".
/// @param sides fewest_sides to most_sides
Tool make_pointed_prism(int sides, const PointedPrismSize& size = {});

/// Of make_needle.
struct NeedleSize {
    double radius = 0.75;  ///< mm
    double length = 80;    ///< with the tip, mm; more than the tip's
    double tip_angle = 5;  ///< full angle of the tip, degrees: 1 to 120
};

/// A pointed prism of 16 sides as slender as a needle. Named "needle", or like "needle r0.75 l80 a10".
Tool make_needle(const NeedleSize& size = {});

/// Of make_grasper.
struct GrasperSize {
    double radius = 2.5;     ///< of the circle around the shaft's corners, mm
    double length = 80;      ///< from the plane of the jaws' tips to the handle, mm
    double jaw_length = 18;  ///< from the crotch to a tip along the jaw's inner face, mm
    double opening = 20;     ///< between each jaw's inner face and the axis, degrees: 1 to 60
};

/// A grasper with open jaws, not convex: an octagonal shaft that splits into two jaws, in the plane of y and
/// z. Each tapers from half of the octagon to one of half the size. The origin is midway between the jaws'
/// tips. Named "grasper", or like "grasper r2.5 l80 j18 o30".
Tool make_grasper(const GrasperSize& size = {});

}  // namespace trocar
