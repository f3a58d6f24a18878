#include "tests/strategies/single_vertex.h"

#include "common/tool/tool_shapes.h"

namespace trocar::contract {

Scene single_vertex(const Vec3& inside, const std::vector<Vec3>& corners, const Vec3& motion) {
    SurfaceMesh rest;
    rest.positions = {inside};
    rest.positions.insert(rest.positions.end(), corners.begin(), corners.end());
    const auto count = static_cast<Index>(corners.size());
    for (Index k = 0; k < count; ++k) rest.facets.push_back({0, k + 1, (k + 1) % count + 1});

    Scene scene;
    scene.organ = std::make_shared<const Organ>(make_organ("pyramid", rest));
    scene.positions = scene.organ->rest.positions;
    scene.velocities.assign(scene.positions.size(), Vec3::Zero());
    scene.tool = std::make_shared<const Tool>(make_prism(4, 4, 80));
    scene.before.position = -motion;
    scene.detected.collided = {0};
    return scene;
}

std::vector<Vec3> flat_base(const Vec3& vertex) {
    return {vertex + Vec3(3, 0, 0), vertex + Vec3(0, 3, 0), vertex + Vec3(-3, 0, 0), vertex + Vec3(0, -3, 0)};
}

}  // namespace trocar::contract
