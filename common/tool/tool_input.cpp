#include "common/tool/tool_input.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "common/geometry/mesh_input.h"

namespace trocar {
namespace {

/// The smallest turn that takes the unit vector `axis` to +z.
Mat3 upright(const Vec3& axis) {
    if (axis.z() <
        0) {  // half a turn about x first: near −z the formula below would divide by nearly nothing
        const Mat3 half_turn = Vec3(1, -1, -1).asDiagonal();
        return upright(half_turn * axis) * half_turn;
    }
    const Vec3 v = axis.cross(Vec3::UnitZ());
    Mat3 cross;
    cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return Mat3::Identity() + cross + cross * cross / (1 + axis.z());
}

/// Centroid of the volume inside a closed mesh, as the sum over tetrahedra to its first vertex.
Vec3 centroid(const SurfaceMesh& mesh) {
    const Vec3 apex = mesh.positions.front();
    Vec3 moment = Vec3::Zero();
    double volume = 0;
    for (const auto& [a, b, c] : mesh.facets) {
        const Vec3 p = mesh.positions[a] - apex, q = mesh.positions[b] - apex, r = mesh.positions[c] - apex;
        const double six_volumes = p.dot(q.cross(r));
        volume += six_volumes;
        moment += six_volumes * (p + q + r) / 4;
    }
    return apex + moment / volume;
}

Vec3 lowest_on_axis(const SurfaceMesh& mesh, const Vec3& axis) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& position : mesh.positions) lowest = std::min(lowest, axis.dot(position));
    const Vec3 middle = centroid(mesh);
    return middle + (lowest - axis.dot(middle)) * axis;
}

}  // namespace

ToolInput read_tool(const std::filesystem::path& file, const ToolPlacement& placement) {
    CheckedMesh checked = read_checked_mesh(file);
    SurfaceMesh& mesh = checked.mesh;
    const double length = placement.axis.norm();
    if (!(length > 0)) {
        throw MeshError(file.string() + ": the tool's axis is (0, 0, 0): expected a direction");
    }
    const Vec3 axis = placement.axis / length;
    const Vec3 tip = placement.tip.value_or(lowest_on_axis(mesh, axis));
    for (Vec3& position : mesh.positions) position -= tip;
    if (placement.size) scale_to_size(mesh, *placement.size);
    const Mat3 rotation = upright(axis);
    for (Vec3& position : mesh.positions) position = rotation * position;

    std::string name = file.stem().string();
    if (placement.size) name += fmt::format(" s{}", *placement.size);
    try {
        return {make_tool(std::move(name), std::move(mesh)), std::move(checked.findings)};
    } catch (const std::invalid_argument& error) {
        throw MeshError(
            fmt::format("{}: no tool can be made of this mesh; repair it, for example in MeshLab: {}",
                        file.string(), error.what()));
    }
}

}  // namespace trocar
