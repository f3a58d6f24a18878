#include "common/geometry/surface_queries.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<CgalMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using InsideTest = CGAL::Side_of_triangle_mesh<CgalMesh, Kernel, CGAL::Default, AabbTree>;

Point to_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Its faces have the numbers of the mesh's facets.
CgalMesh to_cgal(const SurfaceMesh& mesh) {
    CgalMesh copy;
    for (const Vec3& position : mesh.positions) copy.add_vertex(to_point(position));
    using Vertex = CgalMesh::Vertex_index;
    for (const auto& [a, b, c] : mesh.facets) {
        const auto face = copy.add_face(Vertex(a), Vertex(b), Vertex(c));
        if (face == CgalMesh::null_face()) {
            throw std::invalid_argument("facet " + std::to_string(copy.number_of_faces()) +
                                        " makes the surface not manifold or not consistently oriented");
        }
    }
    return copy;
}

}  // namespace

struct SurfaceQueries::Tree {
    explicit Tree(const SurfaceMesh& asked) : mesh(asked), copy(to_cgal(asked)), inside(build(), Kernel()) {}

    // Everything that CGAL would otherwise prepare at the first question, which may come from several
    // threads.
    const AabbTree& build() {
        tree.insert(faces(copy).first, faces(copy).second, copy);
        tree.build();
        tree.accelerate_distance_queries();
        return tree;
    }

    const SurfaceMesh& mesh;
    CgalMesh copy;
    AabbTree tree;
    InsideTest inside;
};

SurfaceQueries::SurfaceQueries(const SurfaceMesh& mesh) : tree_(std::make_unique<Tree>(mesh)) {}
SurfaceQueries::~SurfaceQueries() = default;

std::optional<double> SurfaceQueries::distance_to_exit(const Vec3& origin, const Vec3& direction,
                                                       double skip) const {
    const Kernel::Ray_3 ray(to_point(origin), Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
    std::vector<CgalMesh::Face_index> met;
    tree_->tree.all_intersected_primitives(ray, std::back_inserter(met));
    std::optional<double> nearest;
    for (const CgalMesh::Face_index face : met) {
        const Facet& facet = tree_->mesh.facets[face.idx()];
        const Vec3 normal = facet_normal(tree_->mesh.positions, facet);
        const double along = normal.dot(direction);
        if (along <= 0) continue;
        const double distance = normal.dot(tree_->mesh.positions[facet[0]] - origin) / along;
        if (distance > skip && (!nearest || distance < *nearest)) nearest = distance;
    }
    return nearest;
}

bool SurfaceQueries::contains(const Vec3& point) const {
    return tree_->inside(to_point(point)) == CGAL::ON_BOUNDED_SIDE;
}

double SurfaceQueries::distance(const Vec3& point) const {
    return std::sqrt(tree_->tree.squared_distance(to_point(point)));
}

}  // namespace trocar
