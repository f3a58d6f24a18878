#include "common/geometry/triangle_distance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace trocar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Line {
    Vec3 origin, direction;
};

Interval everything() { return {-infinity, infinity}; }

/// Keeps the part in which low <= value + t slope <= high.
void clip(Interval& interval, double value, double slope, double low, double high) {
    if (slope == 0) {
        if (value < low || value > high) interval = {};
        return;
    }
    const double at_low = (low - value) / slope, at_high = (high - value) / slope;
    interval.begin = std::max(interval.begin, std::min(at_low, at_high));
    interval.end = std::min(interval.end, std::max(at_low, at_high));
}

void cover(Interval& whole, const Interval& part) {
    if (part.empty()) return;
    whole.begin = std::min(whole.begin, part.begin);
    whole.end = std::max(whole.end, part.end);
}

/// Where `offset` + t `slope` is shorter than `reach`. The offset at the nearest point is computed first:
/// the usual b² − 4ac would lose half of its digits far from the ball.
Interval in_ball(const Vec3& offset, const Vec3& slope, double reach) {
    const double speed = slope.squaredNorm();
    if (speed == 0) return offset.norm() < reach ? everything() : Interval{};
    const double nearest = -offset.dot(slope) / speed;
    const double left = reach * reach - (offset + nearest * slope).squaredNorm();
    if (left <= 0) return {};
    const double half = std::sqrt(left / speed);
    return {nearest - half, nearest + half};
}

Interval in_cylinder(const Line& line, const Vec3& a, const Vec3& b, double reach) {
    const double length = (b - a).norm();
    if (length == 0) return {};
    const Vec3 axis = (b - a) / length, from_a = line.origin - a;
    const double height = from_a.dot(axis), climb = line.direction.dot(axis);
    Interval inside = in_ball(from_a - height * axis, line.direction - climb * axis, reach);
    clip(inside, height, climb, 0, length);
    return inside;
}

Interval in_slab(const Line& line, const Corners& t, double reach) {
    const Vec3 area = (t[1] - t[0]).cross(t[2] - t[0]);
    if (area.isZero(0)) return {};
    const Vec3 normal = area.normalized();
    Interval inside = everything();
    clip(inside, normal.dot(line.origin - t[0]), normal.dot(line.direction), -reach, reach);
    for (int k = 0; k < 3; ++k) {
        const Vec3 outward = (t[(k + 1) % 3] - t[k]).cross(normal);
        clip(inside, outward.dot(line.origin - t[k]), outward.dot(line.direction), -infinity, 0);
    }
    return inside;
}

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const Corners& t) {
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return t[0];
    const Vec3 bp = p - t[1];
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return t[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
    const Vec3 cp = p - t[2];
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return t[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    return t[0] + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

Interval stretch_near(const Vec3& origin, const Vec3& direction, const Corners& triangle, double reach) {
    const Line line{origin, direction};
    Interval whole;
    cover(whole, in_slab(line, triangle, reach));
    for (int k = 0; k < 3; ++k) {
        cover(whole, in_cylinder(line, triangle[k], triangle[(k + 1) % 3], reach));
        cover(whole, in_ball(origin - triangle[k], direction, reach));
    }
    return whole;
}

}  // namespace trocar
