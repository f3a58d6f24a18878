#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "common/geometry/organ_shapes/implicit_surface.h"
#include "common/geometry/organ_shapes/rings.h"
#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {
namespace {

constexpr double half_length = 73;   // mm along the axis, without the rims
constexpr double half_wall = 2;      // mm
constexpr double bend_radius = 220;  // mm, of the axis, an arc in the plane of x and z

// A point by its place along the axis, its distance from it and the angle around it.
struct Place {
    double along, away, around;
};

Place place_of(const Vec3& p) {
    const double x = p.x() + bend_radius - 5;
    const double turn = std::atan2(p.z(), x);
    const double out = std::hypot(x, p.z()) - bend_radius;
    return {bend_radius * turn, std::hypot(out, p.y()), std::atan2(p.y(), out)};
}

Vec3 point_at(const Place& place) {
    const double turn = place.along / bend_radius;
    const double r = bend_radius + place.away * std::cos(place.around);
    return {r * std::cos(turn) - bend_radius + 5, place.away * std::sin(place.around), r * std::sin(turn)};
}

// Radius of the middle of the wall: pouches along the gut, held in along three bands (taeniae).
double middle(const Place& place) {
    const double pouch = std::cos(2 * std::numbers::pi * place.along / 28);
    const double band = std::cos(3 * place.around);
    return 17.2 + 0.8 * pouch - 0.5 * band;
}

double value(const Vec3& p) {
    const Place place = place_of(p);
    const double beyond = std::max(std::abs(place.along) - half_length, 0.0);
    return std::hypot(beyond, place.away - middle(place)) - half_wall;
}

// The crest of each rim.
double crease(const Vec3& p) {
    const Place place = place_of(p);
    return place.away - middle(place);
}

CoarseMesh coarse_mesh() {
    constexpr Index around = 14, along = 17;
    Rings rings(around);
    const auto add = [&](double s, double side) {
        rings.add([&](double angle) {
            Place place{.along = s, .away = 0, .around = angle};
            place.away = middle(place) + side * half_wall;
            return point_at(place);
        });
    };
    const double end = half_length + half_wall;
    add(-end, 0);
    for (Index i = 0; i < along; ++i) add((2.0 * i / (along - 1) - 1) * half_length, 1);
    add(end, 0);
    for (Index i = along; i-- > 0;) add((2.0 * i / (along - 1) - 1) * half_length, -1);
    CoarseMesh coarse{rings.torus(), {}};
    for (const Index first : {0, around * (along + 1)}) {
        for (Index i = 0; i < around; ++i) coarse.creases.push_back({first + i, first + (i + 1) % around});
    }
    return coarse;
}

}  // namespace

Organ make_tube(std::string name, double edge, double size) {
    const ImplicitSurface surface{.value = value, .crease = crease};
    return make_organ(std::move(name), mesh_surface(surface, coarse_mesh(), edge, size / 150));
}

}  // namespace trocar
