#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "common/geometry/organ_shapes/implicit_surface.h"
#include "common/geometry/organ_shapes/rings.h"
#include "common/geometry/organ_shapes/shapes.h"

// Seen from the front: x to the viewer's right (the patient's left), y to the back, z up. Lengths in mm.
namespace trocar {
namespace {

// Near its surface about the distance to it.
double ellipsoid(const Vec3& from_centre, const Vec3& semi_axes) {
    const double k = from_centre.cwiseQuotient(semi_axes).norm();
    return k * (k - 1) / from_centre.cwiseQuotient(semi_axes.cwiseAbs2()).norm();
}

double bell(double x, double width) { return std::exp(-x * x / (width * width)); }

constexpr double fissure = 22;  // x of the plane between the lobes

// The lower surface: rising to the back and to the left, hollow, with a groove along the fissure and a dent
// for the gallbladder.
double bottom(double x, double y) {
    const double hollow = 12 * (1 - (x * x) / (95 * 95) - (y - 8) * (y - 8) / (55 * 55));
    const double groove = 6 * bell(x - fissure, 7) + 7 * bell(x + 18, 13) * bell(y + 25, 30);
    return -17 + 0.6 * y + 0.25 * x + hollow + groove;
}

double above_bottom(const Vec3& p) { return 0.84 * (p.z() - bottom(p.x(), p.y())); }

// The two lobes, of which the dome is the upper part; the fissure is a furrow between them, which deepens to
// a notch at the lower edge.
double dome(const Vec3& p) {
    const double right = ellipsoid(p - Vec3(-36, 15, -50), {65, 60, 112});
    const double left = ellipsoid(p - Vec3(24, 6, -30), {91, 44, 70});
    const double furrow =
        bell(p.x() - fissure, 8) * (2.5 + 18 * bell(above_bottom(p), 14) / (1 + std::exp((p.y() + 12) / 5)));
    return -smooth_max(-right, -left, 35) + furrow;
}

// Sharp in front, round at the back.
double value(const Vec3& p) {
    const double radius = 2 + 30 / (1 + std::exp((30 - p.y()) / 8));
    return smooth_max(dome(p), -above_bottom(p), radius);
}

double crease(const Vec3& p) { return dome(p) + above_bottom(p); }

// The t in [0, most] at which at(t) passes zero, going up.
template <class Function>
double root(Function at, double most) {
    double low = 0, high = most;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (at(middle) < 0 ? low : high) = middle;
    }
    return low;
}

CoarseMesh coarse_mesh() {
    constexpr Index around = 32;
    constexpr double x0 = 12, y0 = 8;
    Rings rings(around);
    const auto lower = [](double x, double y) { return Vec3(x, y, bottom(x, y)); };
    const auto upper = [&](double x, double y) {
        const Vec3 from = lower(x, y);
        return Vec3(from +
                    root([&](double t) { return dome(from + t * Vec3::UnitZ()); }, 150) * Vec3::UnitZ());
    };
    const auto add = [&](double fraction, const auto& surface) {
        rings.add([&](double angle) {
            const double c = std::cos(angle), s = std::sin(angle);
            const double r =
                fraction * root([&](double t) { return dome(lower(x0 + t * c, y0 + t * s)); }, 130);
            return surface(x0 + r * c, y0 + r * s);
        });
    };
    constexpr std::array<double, 3> fractions{0.3, 0.6, 0.85};
    for (const double f : fractions) add(f, lower);
    add(1, lower);
    for (std::size_t i = fractions.size(); i-- > 0;) add(fractions[i], upper);
    CoarseMesh coarse{rings.between_poles(lower(x0, y0), upper(x0, y0)), {}};
    for (Index i = 0; i < around; ++i) {
        coarse.creases.push_back({3 * around + i, 3 * around + (i + 1) % around});
    }
    return coarse;
}

}  // namespace

Organ make_liver(std::string name, double edge, double size) {
    const ImplicitSurface surface{.value = value, .crease = crease};
    return make_organ(std::move(name), mesh_surface(surface, coarse_mesh(), edge, size / 200));
}

}  // namespace trocar
