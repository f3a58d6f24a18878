#include "cgal_oracle.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace trocar::testing_support {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Kernel::Triangle_3 triangle(const Corners& corners) {
    return {point(corners[0]), point(corners[1]), point(corners[2])};
}

Kernel::Segment_3 side(const Corners& corners, int k) {
    return {point(corners[k]), point(corners[(k + 1) % 3])};
}

}  // namespace

std::vector<FacetPair> cgal_self_intersections(const SurfaceMesh& mesh) {
    Mesh copy;
    for (const Vec3& p : mesh.positions) copy.add_vertex(point(p));
    for (const auto& [a, b, c] : mesh.facets) {
        copy.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(copy, std::back_inserter(found));
    std::vector<FacetPair> pairs;
    for (const auto& [one, other] : found) {
        const auto [low, high] = std::minmax({static_cast<Index>(one), static_cast<Index>(other)});
        if (low != high) pairs.push_back({low, high});
    }
    std::ranges::sort(pairs);
    return pairs;
}

bool cgal_triangles_meet(const Corners& one, const Corners& other) {
    return CGAL::do_intersect(triangle(one), triangle(other));
}

double cgal_triangle_distance(const Corners& one, const Corners& other) {
    double least = 1e300;
    for (int i = 0; i < 3; ++i) {
        least = std::min({least, CGAL::to_double(CGAL::squared_distance(point(one[i]), triangle(other))),
                          CGAL::to_double(CGAL::squared_distance(point(other[i]), triangle(one)))});
        for (int j = 0; j < 3; ++j) {
            least = std::min(least, CGAL::to_double(CGAL::squared_distance(side(one, i), side(other, j))));
        }
    }
    return std::sqrt(least);
}

}  // namespace trocar::testing_support
