#pragma once

#include <functional>
#include <vector>

#include "common/geometry/adjacency.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// A number for each point of space.
using Field = std::function<double(const Vec3&)>;

/// A closed surface given by a formula.
struct ImplicitSurface {
    /// Zero on the surface, negative inside, its slope near the surface of the order of 1.
    Field value;
    /// Where this and `value` are zero run the lines that a mesh is to keep however long its edges are:
    /// crests and folds. Left empty when there are none.
    Field crease;
};

/// A first mesh of a surface: of the right topology, its vertices roughly in place.
struct CoarseMesh {
    SurfaceMesh mesh;
    std::vector<Edge> creases;  ///< those of its edges that follow the surface's creases
};

/// Meshes the surface, made `scale` times as large, with edges of about `edge` mm: isotropic remeshing
/// (Botsch and Kobbelt 2004, by CGAL) of `coarse` towards ever shorter edges, every vertex put back on the
/// surface after each round, until the mesh is as good as OrganShape::make promises. The same input gives the
/// same bits. Throws std::invalid_argument when no round gives such a mesh.
SurfaceMesh mesh_surface(const ImplicitSurface& surface, const CoarseMesh& coarse, double edge, double scale);

/// max(a, b), with the corner where a = b rounded off within |a - b| < radius: never less than the maximum,
/// and at most radius / 4 more.
double smooth_max(double a, double b, double radius);

}  // namespace trocar
