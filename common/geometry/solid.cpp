#include "common/geometry/solid.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "common/geometry/flat_edges.h"

namespace trocar {
namespace {

/// Closest point of a triangle, by the regions of its corners, edges and inside (Ericson, "Real-Time
/// Collision Detection", 2005, section 5.1.5).
Vec3 closest_on_triangle(const Vec3& p, const Corners& t) {
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return t[0];
    const Vec3 bp = p - t[1];
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return t[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
    const Vec3 cp = p - t[2];
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return t[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    return t[0] + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

}  // namespace

Solid::Solid(const SurfaceMesh& mesh) : mesh_(mesh), box_(bounding_box(mesh.positions)) {
    const Adjacency adjacency(mesh_.positions.size(), mesh_.facets);
    if (mesh_.facets.empty() || !adjacency.closed()) {
        throw std::invalid_argument("a solid needs a closed mesh; this one has a boundary");
    }
    rounding_ = 1e-9 * box_.size().norm();
    flat_edges_ = flat_edges(mesh_, adjacency);
    gather_faces(adjacency);
    check_convex();
}

void Solid::gather_faces(const Adjacency& adjacency) {
    std::vector<bool> taken(mesh_.facets.size(), false);
    for (std::size_t seed = 0; seed < mesh_.facets.size(); ++seed) {
        if (taken[seed]) continue;
        Face face{.normal = Vec3::Zero(), .offset = 0, .facets = {static_cast<Index>(seed)}};
        taken[seed] = true;
        // The list grows while it is walked: a flood over flat edges.
        for (std::size_t next = 0; next < face.facets.size(); ++next) {
            const Index f = face.facets[next];
            face.normal += facet_area_vector(mesh_.positions, mesh_.facets[f]);
            for (int k = 0; k < 3; ++k) {
                if (!flat_edges_[f][k]) continue;
                const Index other = facet_beyond(mesh_, adjacency, f, k);
                if (taken[other]) continue;
                taken[other] = true;
                face.facets.push_back(other);
            }
        }
        face.normal.normalize();
        // The plane touches the furthest vertex, so that rounding never puts a vertex above a face.
        face.offset = -std::numeric_limits<double>::infinity();
        for (const Vec3& position : mesh_.positions) {
            face.offset = std::max(face.offset, face.normal.dot(position));
        }
        faces_.push_back(std::move(face));
    }
}

void Solid::check_convex() const {
    for (const Face& face : faces_) {
        for (const Vec3& position : mesh_.positions) {
            if (exact_side(face, position) <= 0) continue;
            throw std::invalid_argument(
                "a tool must be convex with its normals outwards; a vertex of this mesh lies above one of "
                "its "
                "facets");
        }
    }
}

Corners Solid::corners(Index facet) const {
    const Facet& f = mesh_.facets[facet];
    return {mesh_.positions[f[0]], mesh_.positions[f[1]], mesh_.positions[f[2]]};
}

int Solid::exact_side(const Face& face, const Vec3& point) const {
    const Corners plane = corners(face.facets.front());
    return orientation_sign(plane[0], plane[1], plane[2], point);
}

bool Solid::contains(const Vec3& point) const {
    if (!box_.contains(point)) return false;
    return std::ranges::all_of(faces_, [&](const Face& face) {
        const double above = height(face, point);
        if (above < -rounding_) return true;
        return above <= rounding_ && exact_side(face, point) < 0;
    });
}

double Solid::exit_distance(const Vec3& point, const Vec3& direction, double clearance) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_) {
        const double approach = face.normal.dot(direction);
        if (approach > 0) nearest = std::min(nearest, (clearance - height(face, point)) / approach);
    }
    return std::max(nearest, 0.0);
}

NearestFace Solid::nearest_face(const Vec3& point) const {
    std::size_t nearest = 0;
    double highest = height(faces_.front(), point);
    for (std::size_t k = 1; k < faces_.size(); ++k) {
        const double above = height(faces_[k], point);
        if (above > highest) {
            highest = above;
            nearest = k;
        }
    }
    return {
        .face = static_cast<Index>(nearest), .normal = faces_[nearest].normal, .signed_distance = highest};
}

Vec3 Solid::closest_point(const Vec3& point) const {
    Vec3 closest = Vec3::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < mesh_.facets.size(); ++f) {
        const Vec3 candidate = closest_on_triangle(point, corners(static_cast<Index>(f)));
        const double distance = (candidate - point).squaredNorm();
        if (distance < least) {
            least = distance;
            closest = candidate;
        }
    }
    return closest;
}

bool Solid::within(const Vec3& point, double distance) const {
    const double above = nearest_face(point).signed_distance;
    if (above <= 0) return true;
    // A face's plane is never further away than the solid behind it.
    return above <= distance && (closest_point(point) - point).norm() <= distance;
}

Vec3 Solid::support(const Vec3& direction) const {
    return *std::ranges::max_element(mesh_.positions, {}, [&](const Vec3& p) { return p.dot(direction); });
}

bool Solid::crossed_by(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Corners organ{a, b, c};
    bool crosses = false;
    for (const Face& face : faces_) {
        const auto [lowest, highest] = std::minmax({height(face, a), height(face, b), height(face, c)});
        if (lowest > rounding_) return false;  // the whole facet is above a face of a convex solid
        if (crosses || highest < -rounding_) continue;
        crosses = std::ranges::any_of(
            face.facets, [&](Index f) { return facets_cross(organ, corners(f), flat_edges_[f]); });
    }
    return crosses;
}

}  // namespace trocar
