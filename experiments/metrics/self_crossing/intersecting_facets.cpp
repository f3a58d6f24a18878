#include "experiments/metrics/self_crossing/intersecting_facets.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

/// Where vertices are, as CGAL asks for it.
struct PointsOf {
    using key_type = Vertex;
    using value_type = Kernel::Point_3;
    using reference = Kernel::Point_3;
    using category = boost::readable_property_map_tag;

    std::span<const Vec3> positions;

    friend Kernel::Point_3 get(const PointsOf& points, Vertex vertex) {
        const Vec3& p = points.positions[vertex.idx()];
        return {p.x(), p.y(), p.z()};
    }
};

}  // namespace

struct IntersectingFacets::CgalMesh {
    Mesh mesh;  // its faces have the numbers of the facets; its points mean nothing
};

IntersectingFacets::IntersectingFacets(const SurfaceMesh& mesh) : mesh_(std::make_unique<CgalMesh>()) {
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) mesh_->mesh.add_vertex();
    for (std::size_t k = 0; k < mesh.facets.size(); ++k) {
        const auto& [a, b, c] = mesh.facets[k];
        if (mesh_->mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) {
            throw std::invalid_argument("facet " + std::to_string(k) +
                                        " makes the surface not manifold or not consistently oriented");
        }
    }
}

IntersectingFacets::~IntersectingFacets() = default;

std::vector<FacetPair> IntersectingFacets::pairs(std::span<const Index> facets,
                                                 std::span<const Vec3> positions) const {
    std::vector<Mesh::Face_index> faces;
    faces.reserve(facets.size());
    for (const Index facet : facets) faces.emplace_back(facet);
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(
        faces, mesh_->mesh, std::back_inserter(found),
        CGAL::parameters::vertex_point_map(PointsOf{positions}).geom_traits(Kernel()));
    std::vector<FacetPair> pairs;
    for (const auto& [one, other] : found) {
        if (one == other) continue;
        const auto [low, high] =
            std::minmax({static_cast<Index>(one.idx()), static_cast<Index>(other.idx())});
        pairs.push_back({low, high});
    }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace trocar
