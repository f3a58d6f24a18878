#include "tests/strategies/scenes.h"

#include <algorithm>
#include <map>
#include <random>

#include <Eigen/Geometry>

#include "common/geometry/organ_shapes.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool_shapes.h"

namespace trocar::contract {
namespace {

using Generator = std::mt19937_64;

/// Scenes are the same in every run.
Generator generator_of(std::uint64_t seed) { return Generator(seed); }

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

/// A point inside the tool, at most 12 mm from the plane of its tip.
Vec3 point_inside(Generator& generator, const Tool& tool) {
    const Box& box = tool.solid.box();
    const double top = std::min(box.high.z(), box.low.z() + 12);
    Vec3 point;
    do {
        point = {between(generator, box.low.x(), box.high.x()), between(generator, box.low.y(), box.high.y()),
                 between(generator, box.low.z(), top)};
    } while (!tool.solid.contains(point));
    return point;
}

Mat3 turn(double angle, const Vec3& about) { return Eigen::AngleAxisd(angle, about).toRotationMatrix(); }

/// The rotation that takes +z to `axis`.
Mat3 upright(const Vec3& axis) {
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis).toRotationMatrix();
}

/// Organs and tools are made once; scenes share them.
template <typename Thing>
std::shared_ptr<const Thing> shared(const std::string& formula, Thing (*make)(std::string_view)) {
    static std::map<std::string, std::shared_ptr<const Thing>> made;
    auto& thing = made[formula];
    if (!thing) thing = std::make_shared<const Thing>(make(formula));
    return thing;
}

void detect(Scene& scene) {
    Detector detector(*scene.organ);
    detector.follow_all(scene.positions);
    detector.detect(scene.positions, *scene.tool, ToolMotion(scene.before, scene.after), scene.detected);
}

/// The organ at rest and the tool where it is made; nothing is detected yet.
Scene world(std::shared_ptr<const Organ> organ, const std::string& tool) {
    Scene scene;
    scene.organ = std::move(organ);
    scene.positions = scene.organ->rest.positions;
    scene.velocities.assign(scene.positions.size(), Vec3::Zero());
    scene.tool = shared(tool, make_tool_by_formula);
    return scene;
}

Index vertex_nearest(const Organ& organ, const Vec3& point) {
    const auto& positions = organ.rest.positions;
    const auto nearest =
        std::ranges::min_element(positions, {}, [&](const Vec3& p) { return (p - point).squaredNorm(); });
    return static_cast<Index>(nearest - positions.begin());
}

/// The tool upright in an organ, after a step of `motion`; the organ's vertex nearest to `at` is inside.
Scene upright_scene(const char* organ, const Vec3& at, const std::string& tool, const Vec3& motion) {
    Scene scene = world(shared(organ, make_organ_by_formula), tool);
    Generator generator = generator_of(1);
    const Vec3& entry = scene.positions[vertex_nearest(*scene.organ, at)];
    scene.after.position = entry - point_inside(generator, *scene.tool);
    scene.before.position = scene.after.position - motion;
    detect(scene);
    return scene;
}

/// … in the north pole of a sphere.
Scene pole_scene(const std::string& tool, const Vec3& motion) {
    return upright_scene("sphere@4mm", {0, 0, 40}, tool, motion);
}

/// Every vertex of a closed organ within the tool.
Scene swallowed_scene(const std::string& tool) {
    const auto shape = shared(tool, make_tool_by_formula);
    const SurfaceQueries queries(shape->mesh);
    Generator generator = generator_of(1);
    Vec3 middle = point_inside(generator, *shape);
    for (int k = 0; k < 20; ++k) {
        const Vec3 other = point_inside(generator, *shape);
        if (queries.distance(other) > queries.distance(middle)) middle = other;
    }
    SurfaceMesh small = make_organ_by_formula("sphere@16mm").rest;
    const double radius = small.positions.front().norm();
    for (Vec3& p : small.positions) p = middle + p * (0.5 * queries.distance(middle) / radius);
    Scene scene = world(std::make_shared<const Organ>(make_organ("small", small)), tool);
    scene.before.position.x() = -7;
    detect(scene);
    return scene;
}

/// Vertices `depth` mm below the middles of the tool's facets and edges, and below its corners.
Scene surface_scene(const std::string& tool, double depth) {
    Scene scene = pole_scene(tool, {0, 0, -3});
    const SurfaceMesh& mesh = scene.tool->mesh;
    std::vector<Vec3> below;
    for (std::size_t f = 0; f < mesh.facets.size(); f += 1 + mesh.facets.size() / 20) {
        const auto& [a, b, c] = mesh.facets[f];
        const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
        const Vec3 inwards = -depth * facet_normal(mesh.positions, mesh.facets[f]);
        for (const Vec3& on : {Vec3((pa + pb + pc) / 3), Vec3((pa + pb) / 2), pa})
            below.emplace_back(on + inwards);
    }
    for (std::size_t k = 0; k < below.size() && k < scene.positions.size(); ++k) {
        scene.positions[k] = scene.after.to_world(below[k]);
    }
    detect(scene);
    return scene;
}

}  // namespace

const std::vector<std::string>& contract_tools() {
    static const std::vector<std::string> tools = {"prism-3", "prism-12", "pointed-prism-12", "needle",
                                                   "grasper"};
    return tools;
}

Scene random_scene(std::uint64_t seed, const std::string& tool) {
    Generator generator = generator_of(seed);
    const bool on_sheet = between(generator, 0, 1) < 0.3;
    Scene scene = world(shared(on_sheet ? "sheet@3mm" : "sphere@3mm", make_organ_by_formula), tool);
    for (Vec3& position : scene.positions) position += 0.3 * direction(generator);
    for (Vec3& velocity : scene.velocities) velocity = 50 * direction(generator);
    while (scene.detected.collided.empty()) {
        const Vec3& entry = scene.positions[generator() % scene.positions.size()];
        const Vec3 normal = on_sheet ? Vec3(Vec3::UnitZ()) : Vec3(entry.normalized());
        const Vec3 axis = (normal + 0.5 * direction(generator)).normalized();
        scene.after.rotation = upright(axis) * turn(between(generator, 0, 6), Vec3::UnitZ());
        scene.after.position = entry - scene.after.rotation * point_inside(generator, *scene.tool);
        scene.before.rotation =
            turn(between(generator, -0.1, 0.1), direction(generator)) * scene.after.rotation;
        scene.before.position = scene.after.position + between(generator, 0.1, 10) * direction(generator);
        detect(scene);
    }
    return scene;
}

Scene random_scene(std::uint64_t seed) {
    return random_scene(seed, contract_tools()[seed % contract_tools().size()]);
}

std::vector<NamedScene> scenes_without_contact() {
    const auto over_sheet = [](double from, double to) {
        Scene scene = world(shared("sheet@5mm", make_organ_by_formula), "prism-12");
        scene.before.position = {0.1, 0.2, from};
        scene.after.position = {0.1, 0.2, to};
        detect(scene);
        return scene;
    };
    return {{"a tool far away", over_sheet(60, 50)},
            {"a tool that nearly touches", over_sheet(3, 0.001)},
            {"a tool that leaves", over_sheet(-5, 0.001)},
            {"a tool that went through to the other side", over_sheet(5, -100)}};
}

std::vector<NamedScene> degenerate_scenes(const std::string& tool) {
    std::vector<NamedScene> scenes;
    const Vec3 down(0, 0, -3);
    scenes.push_back({"a tool that did not move", pole_scene(tool, Vec3::Zero())});
    scenes.push_back({"motion along the surface", pole_scene(tool, {3, 0, 0})});
    scenes.push_back({"a step of 13 mm", pole_scene(tool, {0, 0, -13})});

    Scene turning = pole_scene(tool, Vec3::Zero());
    turning.before.rotation = turn(0.2, Vec3::UnitZ());
    scenes.push_back({"a turn about the axis", turning});

    Scene on_axis = pole_scene(tool, down);
    const Index moved = on_axis.detected.collided.front();
    on_axis.positions[moved] = on_axis.after.position;
    for (const double end = on_axis.tool->solid.box().high.z(); on_axis.positions[moved].z() < end;) {
        on_axis.positions[moved].z() += 0.5;
        if (on_axis.with_contact([&](const Contact& c) { return c.tool.contains(c.positions[moved]); }))
            break;
    }
    detect(on_axis);
    scenes.push_back({"a vertex on the tool's axis", on_axis});

    Scene flat = pole_scene(tool, down);
    const Index squeezed = flat.detected.collided.front();
    for (const Index neighbour : flat.organ->adjacency.neighbours(squeezed)) {
        flat.positions[neighbour] = flat.positions[squeezed];
    }
    detect(flat);
    scenes.push_back({"facets without area", flat});

    Scene single = pole_scene(tool, down);
    single.detected.collided.resize(1);
    scenes.push_back({"one collided vertex", single});

    const Scene square = upright_scene("sheet@5mm", {0, 0, 0}, tool, down);
    scenes.push_back({"normals along the tool's axis", square});
    scenes.push_back({"every vertex collided", swallowed_scene(tool)});
    scenes.push_back({"vertices 1e-9 mm inside the tool", surface_scene(tool, 1e-9)});
    scenes.push_back({"vertices 1e-13 mm inside the tool", surface_scene(tool, 1e-13)});
    return scenes;
}

}  // namespace trocar::contract
