#include "strategies/fuzzy/membership.h"

#include <cmath>

#include <gtest/gtest.h>

namespace trocar::fuzzy {
namespace {

struct Known {
    Curve curve;
    std::array<double, 4> at;
    double x, degree;
};

class KnownDegree : public testing::TestWithParam<Known> {};

TEST_P(KnownDegree, IsThat) {
    const Known& known = GetParam();
    EXPECT_DOUBLE_EQ(degree({.curve = known.curve, .at = known.at, .height = 1}, known.x), known.degree);
    EXPECT_DOUBLE_EQ(degree({.curve = known.curve, .at = known.at, .height = 0.5}, known.x),
                     known.degree / 2);
}

INSTANTIATE_TEST_SUITE_P(
    Curves, KnownDegree,
    testing::Values(
        Known{Curve::triangle, {0, 1, 3}, -0.1, 0}, Known{Curve::triangle, {0, 1, 3}, 0.25, 0.25},
        Known{Curve::triangle, {0, 1, 3}, 1, 1}, Known{Curve::triangle, {0, 1, 3}, 2.5, 0.25},
        Known{Curve::triangle, {0, 0, 1}, 0, 1}, Known{Curve::triangle, {0, 1, 1}, 1, 1},
        Known{Curve::trapezoid, {0, 1, 2, 4}, 0.5, 0.5}, Known{Curve::trapezoid, {0, 1, 2, 4}, 1.5, 1},
        Known{Curve::trapezoid, {0, 1, 2, 4}, 3, 0.5}, Known{Curve::trapezoid, {0, 1, 2, 4}, 4.5, 0},
        Known{Curve::trapezoid, {0, 0, 1, 1}, 0, 1}, Known{Curve::ramp, {0, 2}, -1, 0},
        Known{Curve::ramp, {0, 2}, 0.5, 0.25}, Known{Curve::ramp, {0, 2}, 3, 1},
        Known{Curve::ramp, {2, 0}, 0.5, 0.75}, Known{Curve::ramp, {2, 0}, -1, 1},
        Known{Curve::rectangle, {0, 1}, 0, 1}, Known{Curve::rectangle, {0, 1}, 1, 1},
        Known{Curve::rectangle, {0, 1}, 1.01, 0}, Known{Curve::s_shape, {0, 2}, 0.5, 0.125},
        Known{Curve::s_shape, {0, 2}, 1, 0.5}, Known{Curve::s_shape, {0, 2}, 1.5, 0.875},
        Known{Curve::s_shape, {0, 2}, 5, 1}, Known{Curve::z_shape, {0, 2}, 0.5, 0.875},
        Known{Curve::z_shape, {0, 2}, -5, 1}, Known{Curve::z_shape, {0, 2}, 5, 0},
        Known{Curve::pi_shape, {0, 2, 3, 5}, 0.5, 0.125}, Known{Curve::pi_shape, {0, 2, 3, 5}, 2.5, 1},
        Known{Curve::pi_shape, {0, 2, 3, 5}, 4.5, 0.125}, Known{Curve::gaussian, {1, 2}, 1, 1},
        Known{Curve::gaussian, {1, 2}, 3, std::exp(-0.5)}));

}  // namespace
}  // namespace trocar::fuzzy
