#include <cmath>
#include <string>
#include <utility>

#include "common/geometry/organ_shapes/implicit_surface.h"
#include "common/geometry/organ_shapes/rings.h"
#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {
namespace {

constexpr double length = 80;  // mm, from the fundus (z = -40) to the neck's end

// Radius² at `s` mm from the fundus. The first two factors close the ends round; the third, a step from the
// body's width to the neck's, was chosen to give 17.5 mm at s = 28, 9 mm at 60 and 6 mm at 70.
double radius_squared(double s) { return s * (length - s) * (0.045 + 0.19 / (1 + std::exp((s - 45) / 8))); }

// The neck bends away from the body's axis.
double bend(double z) {
    const double s = z / length + 0.5;
    return 4 - 16 * s * s * s;
}

double value(const Vec3& p) {
    const double x = p.x() - bend(p.z());
    // |gradient| of the numerator is twice the radius on the side and about 15 at the ends.
    return (x * x + p.y() * p.y() - radius_squared(p.z() + length / 2)) / 30;
}

CoarseMesh coarse_mesh() {
    Rings rings(8);
    for (const double s : {3.0, 8.0, 15.0, 24.0, 33.0, 42.0, 51.0, 60.0, 69.0, 76.0}) {
        const double z = s - length / 2;
        const double r = std::sqrt(radius_squared(s));
        rings.add([&](double angle) { return Vec3(bend(z) + r * std::cos(angle), r * std::sin(angle), z); });
    }
    return {rings.between_poles({bend(-length / 2), 0, -length / 2}, {bend(length / 2), 0, length / 2}), {}};
}

}  // namespace

Organ make_gallbladder(std::string name, double edge, double size) {
    const ImplicitSurface surface{.value = value, .crease = {}};
    return make_organ(std::move(name), mesh_surface(surface, coarse_mesh(), edge, size / 80));
}

}  // namespace trocar
