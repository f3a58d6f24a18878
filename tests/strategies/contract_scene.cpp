#include "tests/strategies/contract_scene.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"

namespace trocar::contract {
namespace {

using Generator = std::mt19937_64;

double between(Generator& generator, double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(generator() >> 11U), -53);
}

Vec3 direction(Generator& generator) {
    Vec3 v;
    do {
        v = {between(generator, -1, 1), between(generator, -1, 1), between(generator, -1, 1)};
    } while (v.norm() < 0.1 || v.norm() > 1);
    return v.normalized();
}

Mat3 turn(double angle, const Vec3& about) { return Eigen::AngleAxisd(angle, about).toRotationMatrix(); }

/// The rotation that takes +z to `axis`.
Mat3 upright(const Vec3& axis) {
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis).toRotationMatrix();
}

void detect(Scene& scene) {
    Detector(*scene.organ)
        .detect(scene.positions, *scene.tool, ToolMotion(scene.before, scene.after), scene.detected);
}

Scene scene_of(Organ organ, Tool tool, const Pose& before, const Pose& after) {
    Scene scene;
    scene.organ = std::make_shared<const Organ>(std::move(organ));
    scene.positions = scene.organ->rest.positions;
    scene.velocities.assign(scene.positions.size(), Vec3::Zero());
    scene.tool = std::make_shared<const Tool>(std::move(tool));
    scene.before = before;
    scene.after = after;
    detect(scene);
    return scene;
}

/// A tool 5 mm deep in the north pole of a sphere, after a step of 3 mm straight down.
Scene plain_scene() {
    const Pose before{.rotation = Mat3::Identity(), .position = {0.1, 0.2, 38}};
    Pose after = before;
    after.position.z() = 35;
    return scene_of(make_organ_by_formula("sphere@4mm"), make_prism(12), before, after);
}

std::vector<Index> shuffled_numbers(std::size_t count, std::uint64_t seed) {
    std::vector<Index> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    std::ranges::shuffle(numbers, Generator(seed));
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

Scene random_scene(std::uint64_t seed) {
    Generator generator(seed);
    Scene scene;
    do {
        const bool on_sheet = between(generator, 0, 1) < 0.3;
        const Vec3 normal = on_sheet ? Vec3(Vec3::UnitZ()) : direction(generator);
        const Vec3 entry =
            on_sheet ? Vec3(between(generator, -40, 40), between(generator, -40, 40), 0) : Vec3(40 * normal);
        const Vec3 axis = (normal + 0.5 * direction(generator)).normalized();
        Pose after{.rotation = upright(axis), .position = entry - between(generator, 0, 8) * axis};
        Pose before = after;
        before.position += between(generator, 0.1, 10) * direction(generator);
        before.rotation = turn(between(generator, -0.1, 0.1), direction(generator)) * after.rotation;
        const int sides = 3 + static_cast<int>(between(generator, 0, 12));
        scene = scene_of(make_organ_by_formula(on_sheet ? "sheet@5mm" : "sphere@5mm"), make_prism(sides),
                         before, after);
        for (Vec3& position : scene.positions) position += 0.3 * direction(generator);
        for (Vec3& velocity : scene.velocities) velocity = 50 * direction(generator);
        detect(scene);
    } while (scene.detected.collided.empty());
    return scene;
}

Scene scene_without_contact() {
    Scene scene = plain_scene();
    scene.before.position.z() = 60;
    scene.after.position.z() = 50;
    detect(scene);
    return scene;
}

std::vector<NamedScene> degenerate_scenes() {
    std::vector<NamedScene> scenes;

    Scene still = plain_scene();
    still.before = still.after;
    scenes.push_back({"a tool that did not move", still});

    Scene on_axis = plain_scene();
    on_axis.positions[on_axis.detected.collided.front()] = on_axis.after.to_world({0, 0, 2});
    detect(on_axis);
    scenes.push_back({"a vertex on the tool's axis", on_axis});

    Scene flat = plain_scene();
    const Index squeezed = flat.detected.collided.front();
    const Vec3 same = flat.positions[squeezed];
    for (const Index neighbour : flat.organ->adjacency.neighbours(squeezed)) flat.positions[neighbour] = same;
    detect(flat);
    scenes.push_back({"facets without area", flat});

    Scene single = plain_scene();
    single.detected.collided.resize(1);
    scenes.push_back({"one collided vertex", single});

    const Pose around{.rotation = Mat3::Identity(), .position = {0, 0, -40}};
    Pose from = around;
    from.position.x() = -7;
    SurfaceMesh small = make_organ_by_formula("sphere@16mm").rest;
    for (Vec3& position : small.positions) position *= 0.05;
    scenes.push_back(
        {"every vertex collided", scene_of(make_organ("small", small), make_prism(8), from, around)});

    Scene sideways = plain_scene();
    sideways.before.position = sideways.after.position + Vec3(3, 0, 0);
    scenes.push_back({"motion along the surface", sideways});

    Scene deepest = plain_scene();
    deepest.before = deepest.after = {.rotation = Mat3::Identity(), .position = {0, 0, 0}};
    deepest.before.position.z() = 13;
    detect(deepest);
    scenes.push_back({"a step of 13 mm", deepest});
    return scenes;
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
