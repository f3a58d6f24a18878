#include "common/geometry/surface_queries.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "common/geometry/triangle_distance.h"

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<CgalMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using InsideTest = CGAL::Side_of_triangle_mesh<CgalMesh, Kernel, CGAL::Default, AabbTree>;

using Node = CGAL::AABB_node<CGAL::AABB_traits<Kernel, Primitive>>;

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

Box box_of(const Node& node) {
    const CGAL::Bbox_3& box = node.bbox();
    return {{box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()}};
}

Corners corners_of(const SurfaceMesh& mesh, Index facet) {
    const Facet& f = mesh.facets[facet];
    return {mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]};
}

/// A search of CGAL's tree for the facets whose boxes meet a box.
struct Near {
    const SurfaceMesh& mesh;
    const Box& box;
    std::vector<Index> found;

    [[nodiscard]] bool go_further() const { return true; }
    [[nodiscard]] bool do_intersect(const Vec3&, const Node& node) const {
        return box.overlaps(box_of(node));
    }
    void intersection(const Vec3&, const Primitive& primitive) {
        const auto facet = static_cast<Index>(primitive.id().idx());
        Box around;
        for (const Vec3& corner : corners_of(mesh, facet)) around.add(corner);
        if (box.overlaps(around)) found.push_back(facet);
    }
};

/// A search of CGAL's tree, nearer boxes first, for every facet that may be the closest one.
struct Closest {
    using Priority = double;
    struct Candidate {
        Index facet;
        Vec3 position;
        double distance;
    };

    const SurfaceMesh& mesh;
    double rounding;
    std::vector<Candidate> candidates;
    double least = std::numeric_limits<double>::infinity();

    [[nodiscard]] static double distance_to(const Vec3& point, const Node& node) {
        const Box box = box_of(node);
        return (point - point.cwiseMax(box.low).cwiseMin(box.high)).norm();
    }
    [[nodiscard]] bool go_further() const { return true; }
    [[nodiscard]] bool do_intersect(const Vec3& point, const Node& node) const {
        return distance_to(point, node) <= least + rounding;
    }
    [[nodiscard]] std::pair<bool, Priority> do_intersect_with_priority(const Vec3& point,
                                                                       const Node& node) const {
        const double distance = distance_to(point, node);
        return {distance <= least + rounding, -distance};
    }
    void intersection(const Vec3& point, const Primitive& primitive) {
        const auto facet = static_cast<Index>(primitive.id().idx());
        const Vec3 position = closest_on_triangle(point, corners_of(mesh, facet));
        const double distance = (position - point).norm();
        if (distance > least + rounding) return;
        candidates.push_back({facet, position, distance});
        least = std::min(least, distance);
    }
};

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

SurfacePoint SurfaceQueries::closest(const Vec3& point, double rounding) const {
    Closest search{tree_->mesh, rounding, {}};
    tree_->tree.traversal_with_priority(point, search);
    const Closest::Candidate* nearest = nullptr;
    for (const Closest::Candidate& one : search.candidates) {
        if (one.distance > search.least + rounding) continue;
        if (nearest == nullptr || one.facet < nearest->facet) nearest = &one;
    }
    return {.position = nearest->position,
            .facet = nearest->facet,
            .normal = facet_normal(tree_->mesh.positions, tree_->mesh.facets[nearest->facet])};
}

std::vector<Index> SurfaceQueries::facets_near(const Box& box) const {
    Near search{tree_->mesh, box, {}};
    tree_->tree.traversal(Vec3(Vec3::Zero()), search);
    return std::move(search.found);
}

std::optional<std::array<Index, 2>> self_intersection(const SurfaceMesh& mesh) {
    std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(to_cgal(mesh), std::back_inserter(pairs));
    std::optional<std::array<Index, 2>> lowest;
    for (const auto& [one, other] : pairs) {
        const auto [a, b] = std::minmax({static_cast<Index>(one.idx()), static_cast<Index>(other.idx())});
        if (!lowest || std::array{a, b} < *lowest) lowest = {a, b};
    }
    return lowest;
}

}  // namespace trocar
