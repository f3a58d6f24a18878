#include "strategies/fuzzy/membership.h"

#include <algorithm>
#include <cmath>

namespace trocar::fuzzy {
namespace {

/// From 0 at `from` to 1 at `to`, straight, either way round; 0 where they are the same.
double ramp(double x, double from, double to) {
    if (from == to) return 0;
    return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

/// 0 below `from`, 1 above `to`, one parabola to the middle and one from there.
double s_shape(double x, double from, double to) {
    if (x <= from) return 0;
    if (x >= to) return 1;
    const double width = to - from;
    const double low = (x - from) / width, high = (x - to) / width;
    return x <= (from + to) / 2 ? 2 * low * low : 1 - 2 * high * high;
}

double z_shape(double x, double from, double to) { return 1 - s_shape(x, from, to); }

/// 1 from b to c, straight down to 0 at a and d; a side may be a jump.
double trapezoid(double x, double a, double b, double c, double d) {
    if (x < a || x > d) return 0;
    if (x >= b && x <= c) return 1;
    return x < b ? ramp(x, a, b) : ramp(x, d, c);
}

}  // namespace

double degree(const Membership& membership, double x) {
    const auto& [a, b, c, d] = membership.at;
    double unit = 0;
    switch (membership.curve) {
        case Curve::triangle:
            unit = trapezoid(x, a, b, b, c);
            break;
        case Curve::trapezoid:
            unit = trapezoid(x, a, b, c, d);
            break;
        case Curve::ramp:
            unit = ramp(x, a, b);
            break;
        case Curve::rectangle:
            unit = x >= a && x <= b ? 1 : 0;
            break;
        case Curve::s_shape:
            unit = s_shape(x, a, b);
            break;
        case Curve::z_shape:
            unit = z_shape(x, a, b);
            break;
        case Curve::pi_shape:
            unit = s_shape(x, a, b) * z_shape(x, c, d);
            break;
        case Curve::gaussian:
            unit = std::exp(-(x - a) * (x - a) / (2 * b * b));
            break;
    }
    return membership.height * unit;
}

}  // namespace trocar::fuzzy
