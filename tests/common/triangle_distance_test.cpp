#include "common/geometry/triangle_distance.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

const Box around{Vec3::Constant(-2), Vec3::Constant(2)};

double distance(const Vec3& point, const Corners& triangle) {
    return (closest_on_triangle(point, triangle) - point).norm();
}

RC_GTEST_PROP(StretchNear, IsWhereTheTriangleIsNearerThanTheReach, ()) {
    Corners triangle;
    for (Vec3& corner : triangle) corner = random_point(around);
    const Vec3 origin = random_point(around), direction = random_direction();
    const double reach = random_number(0.01, 1);
    const Interval near = stretch_near(origin, direction, triangle, reach);
    for (int k = 0; k < 100; ++k) {
        const double t = random_number(-8, 8), missing = reach - distance(origin + t * direction, triangle);
        RC_PRE(std::abs(missing) > 1e-9);
        RC_ASSERT((t > near.begin && t < near.end) == (missing > 0));
    }
    if (near.empty()) return;
    RC_ASSERT(std::abs(distance(origin + near.begin * direction, triangle) - reach) < 1e-12);
    RC_ASSERT(std::abs(distance(origin + near.end * direction, triangle) - reach) < 1e-12);
}

TEST(StretchNear, AlongAnEdgeAndAcrossATriangleWithoutWidth) {
    const Corners triangle{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)};
    const Interval along = stretch_near({-1, 0, 0}, Vec3::UnitX(), triangle, 0.5);
    EXPECT_NEAR(along.begin, 0.5, 1e-14);
    EXPECT_NEAR(along.end, 3.5, 1e-14);
    const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
    const Interval across = stretch_near({1.5, -3, 0}, Vec3::UnitY(), flat, 0.5);
    EXPECT_NEAR(across.begin, 2.5, 1e-14);
    EXPECT_NEAR(across.end, 3.5, 1e-14);
    EXPECT_TRUE(stretch_near({-1, 0, 0.6}, Vec3::UnitX(), triangle, 0.5).empty());
}

}  // namespace
}  // namespace trocar
