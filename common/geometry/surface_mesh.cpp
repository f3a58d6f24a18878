#include "common/geometry/surface_mesh.h"

#include <Eigen/Geometry>

namespace trocar {

Box bounding_box(std::span<const Vec3> positions) {
    Box box;
    for (const Vec3& position : positions) box.add(position);
    return box;
}

Vec3 facet_area_vector(std::span<const Vec3> positions, const Facet& facet) {
    const Vec3& a = positions[facet[0]];
    return (positions[facet[1]] - a).cross(positions[facet[2]] - a) / 2;
}

Vec3 facet_normal(std::span<const Vec3> positions, const Facet& facet) {
    const Vec3 area = facet_area_vector(positions, facet);
    const double length = area.norm();
    return length > 0 ? Vec3(area / length) : Vec3(Vec3::Zero());
}

std::vector<double> facet_areas(const SurfaceMesh& mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.facets.size());
    for (const Facet& facet : mesh.facets) areas.push_back(facet_area_vector(mesh.positions, facet).norm());
    return areas;
}

double signed_volume(const SurfaceMesh& mesh) {
    // Measured from a point of the mesh: far from the origin the tetrahedra's volumes would cancel badly.
    if (mesh.positions.empty()) return 0;
    const Vec3 origin = mesh.positions.front();
    double volume = 0;
    for (const Facet& facet : mesh.facets) {
        volume += (mesh.positions[facet[0]] - origin).dot(facet_area_vector(mesh.positions, facet)) / 3;
    }
    return volume;
}

}  // namespace trocar
