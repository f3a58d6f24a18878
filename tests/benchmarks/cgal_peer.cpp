#include "tests/benchmarks/cgal_peer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh to_cgal(const SurfaceMesh& mesh) {
    Mesh made;
    for (const Vec3& p : mesh.positions) made.add_vertex({p.x(), p.y(), p.z()});
    const auto vertex = [](Index v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
    for (const auto& [a, b, c] : mesh.facets) made.add_face(vertex(a), vertex(b), vertex(c));
    return made;
}

}  // namespace

struct CgalPeer::Inside {
    explicit Inside(const SurfaceMesh& the_mesh) : mesh(to_cgal(the_mesh)), side(mesh) {}

    Mesh mesh;
    CGAL::Side_of_triangle_mesh<Mesh, Kernel> side;
};

CgalPeer::CgalPeer(const SurfaceMesh& mesh) : inside_(std::make_unique<Inside>(mesh)) {
    (void)contains(mesh.positions.front());  // it builds its tree when it is first asked
}
CgalPeer::~CgalPeer() = default;

bool CgalPeer::contains(const Vec3& point) const {
    return inside_->side({point.x(), point.y(), point.z()}) == CGAL::ON_BOUNDED_SIDE;
}

}  // namespace trocar
