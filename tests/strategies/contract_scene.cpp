#include "tests/strategies/contract_scene.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "strategies/registry.h"

namespace trocar::contract {
namespace {

std::vector<Index> shuffled_numbers(std::size_t count, std::uint64_t seed) {
    std::vector<Index> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    std::ranges::shuffle(numbers, std::mt19937_64(seed));
    return numbers;
}

void renumber(std::vector<Index>& list, const std::vector<Index>& number) {
    for (Index& entry : list) entry = number[entry];
    std::ranges::sort(list);
}

/// The scene with another organ and positions, all else the same.
Scene with_organ(const Scene& scene, SurfaceMesh rest, std::vector<Vec3> positions,
                 std::vector<Vec3> velocities) {
    Scene other = scene;
    other.organ = std::make_shared<const Organ>(make_organ(scene.organ->name, std::move(rest)));
    other.positions = std::move(positions);
    other.velocities = std::move(velocities);
    return other;
}

}  // namespace

Response answer_of(std::string_view name, const Scene& scene, const Options& options) {
    Response response;
    const auto strategy = make_strategy(name, options);
    scene.with_contact([&](const Contact& contact) { strategy->handle(contact, response); });
    return response;
}

Scene moved(const Scene& scene, const Pose& by) {
    SurfaceMesh rest = scene.organ->rest;
    std::vector<Vec3> positions = scene.positions, velocities = scene.velocities;
    for (Vec3& p : rest.positions) p = by.to_world(p);
    for (Vec3& p : positions) p = by.to_world(p);
    for (Vec3& v : velocities) v = by.direction_to_world(v);
    Scene other = with_organ(scene, std::move(rest), std::move(positions), std::move(velocities));
    for (Pose* pose : {&other.before, &other.after}) {
        pose->position = by.to_world(pose->position);
        pose->rotation = by.rotation * pose->rotation;
    }
    return other;
}

Scene scaled(const Scene& scene, double factor) {
    SurfaceMesh rest = scene.organ->rest, tool_mesh = scene.tool->mesh;
    std::vector<Vec3> positions = scene.positions, velocities = scene.velocities;
    for (std::vector<Vec3>* lengths : {&rest.positions, &tool_mesh.positions, &positions, &velocities}) {
        for (Vec3& v : *lengths) v *= factor;
    }
    Scene other = with_organ(scene, std::move(rest), std::move(positions), std::move(velocities));
    other.tool = std::make_shared<const Tool>(make_tool(scene.tool->name, std::move(tool_mesh)));
    other.before.position *= factor;
    other.after.position *= factor;
    other.clearance *= factor;
    return other;
}

Renumbered with_vertices_renumbered(const Scene& scene, std::uint64_t seed) {
    const std::vector<Index> number = shuffled_numbers(scene.positions.size(), seed);
    SurfaceMesh rest = scene.organ->rest;
    std::vector<Vec3> positions = scene.positions, velocities = scene.velocities;
    for (std::size_t old = 0; old < number.size(); ++old) {
        rest.positions[number[old]] = scene.organ->rest.positions[old];
        positions[number[old]] = scene.positions[old];
        velocities[number[old]] = scene.velocities[old];
    }
    for (Facet& facet : rest.facets) {
        for (Index& corner : facet) corner = number[corner];
    }
    Scene other = with_organ(scene, std::move(rest), std::move(positions), std::move(velocities));
    renumber(other.detected.collided, number);
    renumber(other.detected.near_vertices, number);
    return {other, number};
}

Renumbered with_facets_renumbered(const Scene& scene, std::uint64_t seed) {
    const std::vector<Index> number = shuffled_numbers(scene.organ->rest.facets.size(), seed);
    SurfaceMesh rest = scene.organ->rest;
    for (std::size_t old = 0; old < number.size(); ++old)
        rest.facets[number[old]] = scene.organ->rest.facets[old];
    Scene other = with_organ(scene, std::move(rest), scene.positions, scene.velocities);
    renumber(other.detected.crossed, number);
    renumber(other.detected.near_facets, number);
    return {other, number};
}

}  // namespace trocar::contract
