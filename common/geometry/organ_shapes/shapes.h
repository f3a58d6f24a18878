#pragma once

#include <string>

#include "common/geometry/organ.h"

namespace trocar {

/// @{
/// A shape that organ_shapes.h lists: an organ of that name with edges of about `edge` mm, `size` mm across.
/// It trusts that the edge is in its range.
Organ make_sheet(std::string name, double edge, double size);
Organ make_rough_sheet(std::string name, double edge, double size);
Organ make_sphere(std::string name, double edge, double size);
Organ make_tube(std::string name, double edge, double size);
Organ make_gallbladder(std::string name, double edge, double size);
Organ make_liver(std::string name, double edge, double size);
Organ make_cleft(std::string name, double edge, double size);
/// @}

/// The mesh of `sheet`, which `rough-sheet` takes its measure from.
SurfaceMesh sheet_mesh(double edge, double size);

}  // namespace trocar
