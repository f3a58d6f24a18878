#include "experiments/metrics/self_crossing/facet_gap.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "cgal_oracle.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::cgal_triangle_distance;
using testing_support::cgal_triangles_meet;
using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

constexpr double widest = 1e9;  // wider than any gap
const Corners flat = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

Corners moved(const Corners& corners, const Vec3& by) {
    return {corners[0] + by, corners[1] + by, corners[2] + by};
}

TEST(FacetGap, IsTheDistanceOfTwoTriangles) {
    EXPECT_NEAR(facet_gap(flat, moved(flat, {0.5, 0.5, 2}), widest), 2, 1e-12) << "one above the other";
    EXPECT_NEAR(facet_gap(flat, moved(flat, {7, 0, 0}), widest), 3, 1e-12) << "corner to corner";
    EXPECT_NEAR(facet_gap(flat, {Vec3(5, 5, 1), Vec3(5, 5, 9), Vec3(9, 9, 4)}, widest), std::sqrt(19), 1e-12)
        << "side to corner";
    EXPECT_NEAR(facet_gap(flat, {Vec3(1, -2, -5), Vec3(1, -2, 5), Vec3(1, -9, 0)}, widest), 2, 1e-12)
        << "side to side";
}

TEST(FacetGap, IsNoneWhereTrianglesMeet) {
    EXPECT_EQ(facet_gap(flat, flat, widest), 0);
    EXPECT_EQ(facet_gap(flat, moved(flat, {1, 1, 0}), widest), 0) << "in one plane";
    EXPECT_EQ(facet_gap(flat, moved(flat, {4, 0, 0}), widest), 0) << "touching";
    EXPECT_EQ(facet_gap(flat, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 0)}, widest), 0) << "crossing";
    EXPECT_TRUE(shown_apart(flat, moved(flat, {0, 0, 1e-9})));
    EXPECT_FALSE(shown_apart(flat, moved(flat, {0, 0, 1e-15}))) << "within rounding";
}

TEST(FacetGap, StopsWhenItIsWideEnough) {
    const Corners other = moved(flat, {7, 0, 2});
    const double enough = facet_gap(flat, other, 0.5), all = facet_gap(flat, other, widest);
    EXPECT_GT(enough, 0.5);
    EXPECT_LE(enough, all);
}

TEST(FacetGap, AgreesWithCgal) {
    int apart = 0;
    EXPECT_TRUE(rc::check([&] {
        const Vec3 far = random_number(0, 200) * random_direction();
        const Box box = {far - Vec3(1, 1, random_number(0, 1)), far + Vec3(1, 1, 1)};
        const Corners one = {random_point(box), random_point(box), random_point(box)};
        Corners other = {random_point(box), random_point(box), random_point(box)};
        other = moved(other, random_number(0, 2) * random_direction());
        const double gap = facet_gap(one, other, widest);
        RC_ASSERT(shown_apart(one, other) == (gap > 0));
        if (cgal_triangles_meet(one, other)) {
            RC_ASSERT(gap == 0);
            return;
        }
        ++apart;
        const double distance = cgal_triangle_distance(one, other);
        RC_ASSERT(gap <= distance * (1 + 1e-12));
        RC_ASSERT(gap >= distance * (1 - 1e-9) - 1e-11);
    }));
    EXPECT_GT(apart, 20);
}

}  // namespace
}  // namespace trocar
