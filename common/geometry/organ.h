#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/geometry/adjacency.h"
#include "common/geometry/patches.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Where a cleft opens: a straight line between its lips.
struct Mouth {
    Vec3 point;     ///< the middle of the line, mm
    Vec3 normal;    ///< unit, out of the cleft
    Vec3 along;     ///< unit, along the line
    double length;  ///< of the line, mm
};

/// The rectangle |x| <= half_x, |y| <= half_y (mm) over which an organ lies as one sheet: above every point
/// of it, and of nothing else, there is one point of the surface. The same point (x, y) names the same place
/// on every organ of that outline.
struct Outline {
    double half_x, half_y;
};

/// An organ at rest: everything about it that no step changes. Shared, read-only, by all cases that use it.
struct Organ {
    std::string name;  ///< as it is written in results, such as "sphere@4mm"
    SurfaceMesh rest;
    Adjacency adjacency;
    std::vector<Vec3> rest_normals;  ///< outer unit normal of each facet at rest
    std::vector<double> rest_areas;  ///< area of each facet at rest, mm²
    std::vector<Patch> patches;      ///< of the surface at rest
    std::optional<Mouth> mouth;      ///< of an organ with a cleft
    std::optional<Outline> outline;  ///< of an open sheet made by formula
};

/// An organ without mouth or outline. Throws std::invalid_argument when the mesh is not manifold (see
/// Adjacency).
Organ make_organ(std::string name, SurfaceMesh rest);

}  // namespace trocar
