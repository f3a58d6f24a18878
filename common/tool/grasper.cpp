#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "common/tool/shape_parts.h"
#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

constexpr Index corners = 8;             // of the shaft
constexpr Index half = corners / 2;      // edges of a jaw's outside
constexpr Index jaw_corners = half + 1;  // of a jaw's section
constexpr Index crotch = 0;              // first of the ring where the jaws begin
constexpr Index handle = corners;        // first of the ring at the handle
constexpr Index tips = 2 * corners;      // first of the tip of the jaw at +y; the other's follow
constexpr double taper = 0.5;            // of a jaw, from the crotch to its tip

/// To a multiple of 2^-20 mm. On that grid the sums and halves below are exact, so that the edges of a side
/// at both its ends are exactly parallel and its corners exactly in one plane.
double on_grid(double mm) { return std::ldexp(std::round(std::ldexp(mm, 20)), -20); }

struct Jaws {
    double start;   // height of the crotch above the tips, mm
    double spread;  // of the inner face at a tip from the axis, mm
};

Jaws jaws_of(const GrasperSize& size) {
    const double angle = size.opening * std::numbers::pi / 180;
    return {on_grid(size.jaw_length * std::cos(angle)), on_grid(size.jaw_length * std::sin(angle))};
}

/// The ring of the shaft, with its corners 0 and 4 exactly in the plane between the jaws.
std::vector<Vec3> section(double radius, double z) {
    std::vector<Vec3> points = ring(corners, radius, z);
    for (Vec3& point : points) point = {on_grid(point.x()), on_grid(point.y()), z};
    return points;
}

SurfaceMesh grasper_mesh(const GrasperSize& size) {
    const Jaws jaws = jaws_of(size);
    SurfaceMesh mesh;
    mesh.positions = section(size.radius, jaws.start);
    for (const Vec3& point : section(size.radius, size.length)) mesh.positions.push_back(point);
    for (const int side : {1, -1}) {
        for (Index k = 0; k < jaw_corners; ++k) {
            const Index corner = (side > 0 ? k : half + k) % corners;
            const Vec3 at = mesh.positions[crotch + corner];
            mesh.positions.emplace_back(taper * at.x(), taper * at.y() + side * jaws.spread, 0);
        }
    }
    for (Index k = 0; k < corners; ++k) {
        const Index next = (k + 1) % corners;
        add_side(mesh, crotch + k, crotch + next, handle + next, handle + k);
    }
    add_end(mesh, handle, corners, true);
    for (const Index jaw : {0, 1}) {
        const Index tip = tips + jaw * jaw_corners;
        const auto at_crotch = [&](Index k) { return crotch + (jaw * half + k) % corners; };
        for (Index k = 0; k < half; ++k) {
            add_side(mesh, tip + k, tip + k + 1, at_crotch(k + 1), at_crotch(k));
        }
        add_side(mesh, tip + half, tip, at_crotch(0), at_crotch(half));  // the inner face
        add_end(mesh, tip, jaw_corners, false);
    }
    return mesh;
}

}  // namespace

Tool make_grasper(const GrasperSize& size) {
    const auto& [radius, length, jaw_length, opening] = size;
    check_length("grasper's radius", radius);
    check_length("grasper's length", length);
    check_length("grasper's jaw_length", jaw_length);
    check_angle("grasper's opening", opening, 1, 60);
    if (jaws_of(size).start >= length) {
        throw std::invalid_argument(
            fmt::format("a grasper's jaws of {} mm: expected shorter ones than the whole length of {} mm",
                        jaw_length, length));
    }
    std::string name = "grasper";
    constexpr GrasperSize usual;
    if (radius != usual.radius || length != usual.length || jaw_length != usual.jaw_length ||
        opening != usual.opening) {
        name += fmt::format(" r{} l{} j{} o{}", radius, length, jaw_length, opening);
    }
    return make_tool(std::move(name), grasper_mesh(size));
}

}  // namespace trocar
