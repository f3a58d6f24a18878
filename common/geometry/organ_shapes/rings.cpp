#include "common/geometry/organ_shapes/rings.h"

namespace trocar {

void Rings::join(Index lower, Index upper, SurfaceMesh& mesh) const {
    for (Index i = 0; i < count_; ++i) {
        const Index next = (i + 1) % count_;
        const Index a = lower * count_ + i, b = lower * count_ + next;
        const Index c = upper * count_ + i, d = upper * count_ + next;
        mesh.facets.push_back({a, b, d});
        mesh.facets.push_back({a, d, c});
    }
}

SurfaceMesh Rings::between_poles(const Vec3& below, const Vec3& above) const {
    SurfaceMesh mesh{.positions = points_, .facets = {}};
    const auto size = static_cast<Index>(points_.size());
    mesh.positions.push_back(below);
    mesh.positions.push_back(above);
    for (Index ring = 0; (ring + 1) * count_ < size; ++ring) join(ring, ring + 1, mesh);
    for (Index i = 0; i < count_; ++i) {
        const Index next = (i + 1) % count_, last = size - count_;
        mesh.facets.push_back({size, next, i});
        mesh.facets.push_back({size + 1, last + i, last + next});
    }
    return mesh;
}

SurfaceMesh Rings::torus() const {
    SurfaceMesh mesh{.positions = points_, .facets = {}};
    const auto rings = static_cast<Index>(points_.size()) / count_;
    for (Index ring = 0; ring < rings; ++ring) join(ring, (ring + 1) % rings, mesh);
    return mesh;
}

}  // namespace trocar
