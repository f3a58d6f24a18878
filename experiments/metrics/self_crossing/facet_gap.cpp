#include "experiments/metrics/self_crossing/facet_gap.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace trocar {
namespace {

/// Two triangles in coordinates whose origin is a corner of the first, so that differences are small.
struct Pair {
    Corners one, other;
    double size = 0;  // at least each coordinate, mm

    Pair(const Corners& the_one, const Corners& the_other) : one(the_one), other(the_other) {
        const Vec3 origin = one[0];
        for (Corners* corners : {&one, &other}) {
            for (Vec3& corner : *corners) {
                corner -= origin;
                size = std::max(size, corner.lpNorm<Eigen::Infinity>());
            }
        }
    }
};

/// The slab across `normal`, made narrower by more than the rounding of the products, which is at most four
/// times 2⁻⁵³ of the sum of their terms' sizes.
double gap_along(const Vec3& normal, const Pair& pair) {
    const auto& [a, b, c] = pair.one;
    const auto& [d, e, f] = pair.other;
    const double a_at = normal.dot(a), b_at = normal.dot(b), c_at = normal.dot(c);
    const double d_at = normal.dot(d), e_at = normal.dot(e), f_at = normal.dot(f);
    const double gap = std::max(std::min({d_at, e_at, f_at}) - std::max({a_at, b_at, c_at}),
                                std::min({a_at, b_at, c_at}) - std::max({d_at, e_at, f_at}));
    constexpr double rounding = 1e-14;
    const double safe = gap - rounding * normal.lpNorm<1>() * pair.size;
    return safe > 0 ? safe * (1 - rounding) / normal.norm() : 0;
}

Vec3 side(const Corners& corners, int k) { return corners[(k + 1) % 3] - corners[k]; }

/// Calls `take` with normals of slabs until it returns true: those that find a gap soonest come first.
template <typename Take>
void try_normals(const Pair& pair, const Take& take) {
    const auto faces = {&pair.one, &pair.other};
    for (const Corners* corners : faces) {
        const Vec3 normal = side(*corners, 0).cross(side(*corners, 1));
        for (int k = 0; k < 3; ++k) {  // in its plane, across each side
            if (take(side(*corners, k).cross(normal))) return;
        }
        if (take(normal)) return;
    }
    for (int i = 0; i < 3; ++i) {  // a side of one nearest to a side of the other
        for (int j = 0; j < 3; ++j) {
            if (take(side(pair.one, i).cross(side(pair.other, j)))) return;
        }
    }
}

/// The same for a corner of one that is nearest to a side or a corner of the other. Triangles that are apart
/// have a slab among the normals above, but one of these may be wider.
template <typename Take>
void try_normals_at_corners(const Pair& pair, const Take& take) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Vec3 between = pair.other[j] - pair.one[i];
            const Vec3 of_one = side(pair.one, i), of_other = side(pair.other, j);
            if (take(between) || take(of_one.cross(between.cross(of_one))) ||
                take(of_other.cross(between.cross(of_other)))) {
                return;
            }
        }
    }
}

}  // namespace

double facet_gap(const Corners& one, const Corners& other, double enough) {
    const Pair pair(one, other);
    double widest = 0;
    const auto take = [&](const Vec3& normal) {
        widest = std::max(widest, gap_along(normal, pair));
        return widest > enough;
    };
    try_normals(pair, take);
    if (widest > 0 && widest <= enough) try_normals_at_corners(pair, take);
    return widest;
}

}  // namespace trocar
