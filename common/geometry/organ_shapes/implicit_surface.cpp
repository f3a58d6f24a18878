#include "common/geometry/organ_shapes/implicit_surface.h"

// Otherwise CGAL checks the whole mesh after each of its steps in a build with assertions.
#define CGAL_NDEBUG

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

namespace trocar {
namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using IsCrease = Mesh::Property_map<Mesh::Edge_index, bool>;

Vec3 position(const Mesh& mesh, Vertex vertex) {
    const Point& p = mesh.point(vertex);
    return {p.x(), p.y(), p.z()};
}

Vec3 gradient(const Field& field, const Vec3& p) {
    constexpr double h = 1e-4;  // mm
    Vec3 result;
    for (int k = 0; k < 3; ++k) {
        const Vec3 step = h * Vec3::Unit(k);
        result[k] = (field(p + step) - field(p - step)) / (2 * h);
    }
    return result;
}

constexpr int most_steps = 20;
constexpr double near_enough = 1e-7;  // mm

// Newton's method: the shortest step to where the field, taken as linear, is zero.
Vec3 put_on_surface(const Field& value, Vec3 p) {
    for (int i = 0; i < most_steps; ++i) {
        const double v = value(p);
        if (std::abs(v) < near_enough) break;
        const Vec3 g = gradient(value, p);
        p -= v / g.squaredNorm() * g;
    }
    return p;
}

// The same for two fields at once.
Vec3 put_on_crease(const ImplicitSurface& surface, Vec3 p) {
    for (int i = 0; i < most_steps; ++i) {
        const double v = surface.value(p), c = surface.crease(p);
        if (std::max(std::abs(v), std::abs(c)) < near_enough) break;
        const Vec3 gv = gradient(surface.value, p), gc = gradient(surface.crease, p);
        const double vv = gv.squaredNorm(), vc = gv.dot(gc), cc = gc.squaredNorm();
        p -= ((cc * v - vc * c) * gv + (vv * c - vc * v) * gc) / (vv * cc - vc * vc);
    }
    return p;
}

double mean_edge(const Mesh& mesh) {
    double sum = 0;
    for (const auto e : mesh.edges()) {
        sum += (position(mesh, mesh.vertex(e, 0)) - position(mesh, mesh.vertex(e, 1))).norm();
    }
    return sum / mesh.number_of_edges();
}

// Whether the mesh has what OrganShape::make promises, with a little to spare.
bool is_good(const Mesh& mesh, double edge) {
    const double largest_cosine = std::cos(12 * CGAL_PI / 180);
    for (const auto h : mesh.halfedges()) {
        const Vec3 corner = position(mesh, mesh.source(h));
        const Vec3 side = position(mesh, mesh.target(h)) - corner;
        const Vec3 other = position(mesh, mesh.target(mesh.next(h))) - corner;
        if (side.norm() < 0.505 * edge || side.norm() > 1.98 * edge) return false;
        if (side.dot(other) > largest_cosine * side.norm() * other.norm()) return false;
    }
    return !CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

class Remesher {
  public:
    Remesher(const ImplicitSurface& surface, const CoarseMesh& coarse) : surface_(surface) {
        for (const Vec3& p : coarse.mesh.positions) mesh_.add_vertex({p.x(), p.y(), p.z()});
        for (const Facet& f : coarse.mesh.facets) mesh_.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
        for (const auto& [a, b] : coarse.creases) {
            is_crease_[mesh_.edge(mesh_.halfedge(Vertex(a), Vertex(b)))] = true;
        }
        project();
    }

    // Remeshes until the edges are good for `target`, or nothing more is to be hoped for.
    bool reach(double target, double stretch) {
        const int halvings = std::max(0, static_cast<int>(std::log2(mean_edge(mesh_) / target)));
        for (int left = halvings; left > 0; --left) {
            for (int i = 0; i < 2; ++i) remesh(std::ldexp(target, left));
        }
        // A short edge can be stuck between others that its collapse would make too long: then every other
        // round allows longer ones.
        constexpr int least_rounds = 8, most_rounds = 20;
        for (int round = 1; round <= most_rounds; ++round) {
            const bool loosened = round > least_rounds && round % 2 == 1;
            remesh((loosened ? 1.1 : 1.0) * stretch * target);
            if (round >= least_rounds && is_good(mesh_, target)) return true;
        }
        return false;
    }

    SurfaceMesh take(double scale) {
        mesh_.collect_garbage();
        SurfaceMesh result;
        for (const Vertex v : mesh_.vertices()) result.positions.emplace_back(scale * position(mesh_, v));
        for (const auto face : mesh_.faces()) {
            auto corner = mesh_.vertices_around_face(mesh_.halfedge(face)).begin();
            for (Index& vertex : result.facets.emplace_back()) vertex = static_cast<Index>((*corner++).idx());
        }
        return result;
    }

  private:
    // Where a vertex belongs. Where creases meet, symmetry keeps it on them.
    [[nodiscard]] Point projected(Vertex vertex) const {
        int creases = 0;
        for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(vertex))) {
            creases += is_crease_[mesh_.edge(h)] ? 1 : 0;
        }
        const Vec3 from = position(mesh_, vertex);
        const Vec3 to = creases == 2 ? put_on_crease(surface_, from) : put_on_surface(surface_.value, from);
        return {to.x(), to.y(), to.z()};
    }

    void project() {
        for (const Vertex v : mesh_.vertices()) mesh_.point(v) = projected(v);
    }

    // One round: edges above 4/3 of `length` are split, those below 4/5 collapsed.
    void remesh(double length) {
        CGAL::Polygon_mesh_processing::isotropic_remeshing(
            mesh_.faces(), length, mesh_,
            CGAL::parameters::edge_is_constrained_map(is_crease_)
                .relax_constraints(true)
                .projection_functor([this](Vertex v) { return projected(v); }));
        project();  // CGAL moves the vertices of creases, but does not project them
    }

    const ImplicitSurface& surface_;
    Mesh mesh_;
    IsCrease is_crease_ = mesh_.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
};

}  // namespace

double smooth_max(double a, double b, double radius) {
    const double h = std::max(radius - std::abs(a - b), 0.0);
    return std::max(a, b) + h * h / (4 * radius);
}

SurfaceMesh mesh_surface(const ImplicitSurface& surface, const CoarseMesh& coarse, double edge,
                         double scale) {
    const double target = edge / scale;
    // The first puts CGAL's bounds equally far from half and twice the target. Now and then a round leaves a
    // bad edge at a crease that later rounds cannot remove either; another length takes another way.
    for (const double stretch : {1.1, 1.15, 1.05}) {
        Remesher remesher(surface, coarse);
        if (remesher.reach(target, stretch)) return remesher.take(scale);
    }
    throw std::invalid_argument(fmt::format(
        "edge length {} mm: no mesh found in which every edge and angle is good; take another length", edge));
}

}  // namespace trocar
