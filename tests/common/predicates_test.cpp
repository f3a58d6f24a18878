#include "common/geometry/predicates.h"

#include <cmath>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/random_numbers.h"

namespace trocar {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

const Corners floor_facet = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

Corners wall(const Vec3& foot, double height) {
    return {foot, foot + Vec3(1, 0, height), foot + Vec3(0, 1, height)};
}

TEST(OrientationSign, IsPositiveAboveTheCounterClockwiseSide) {
    EXPECT_EQ(orientation_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    EXPECT_EQ(orientation_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
}

TEST(OrientationSign, IsExactWhereFloatingPointIsNot) {
    // The fourth point is one unit in the last place above the plane z = x of the others.
    const double x = 0.1 + 0.2;
    const Vec3 a(0, 0, 0), b(1, 0, 1), c(0, 1, 0);
    EXPECT_EQ(orientation_sign(a, b, c, Vec3(x, 0.7, x)), 0);
    EXPECT_EQ(orientation_sign(a, b, c, Vec3(x, 0.7, std::nextafter(x, 1))), 1);
    EXPECT_EQ(orientation_sign(a, b, c, Vec3(x, 0.7, std::nextafter(x, 0))), -1);
}

TEST(FacetsCross, PiercingIsCrossing) {
    EXPECT_TRUE(facets_cross(wall({1, 1, -1}, 2), floor_facet));
    EXPECT_TRUE(facets_cross(floor_facet, wall({1, 1, -1}, 2)));
}

TEST(FacetsCross, TouchingIsNotCrossing) {
    EXPECT_FALSE(facets_cross(wall({1, 1, 0}, 2), floor_facet)) << "a corner on the other's inside";
    EXPECT_FALSE(facets_cross({Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 3)}, floor_facet))
        << "an edge in its plane";
    EXPECT_FALSE(facets_cross({Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(4, 4, 1)}, floor_facet)) << "a shared edge";
    EXPECT_FALSE(facets_cross(floor_facet, floor_facet)) << "the same facet";
    EXPECT_FALSE(facets_cross({Vec3(1, 1, 0), Vec3(3, 1, 0), Vec3(1, 3, 0)}, floor_facet))
        << "coplanar overlap";
}

TEST(FacetsCross, FarAwayIsNotCrossing) {
    EXPECT_FALSE(facets_cross(wall({1, 1, 0.5}, 2), floor_facet));
    EXPECT_FALSE(facets_cross(wall({5, 5, -1}, 2), floor_facet)) << "through the plane, outside the facet";
}

TEST(FacetsCross, PiercingAFlatEdgeIsCrossing) {
    // Passes exactly through the middle of the edge from (4, 0, 0) to (0, 4, 0).
    const Corners needle = {Vec3(2, 2, -1), Vec3(2, 2, 1), Vec3(9, 9, 0.5)};
    EXPECT_FALSE(facets_cross(needle, floor_facet));
    EXPECT_TRUE(facets_cross(needle, floor_facet, {false, true, false}));
}

RC_GTEST_PROP(FacetsCross, EqualsExactIntersectionInGeneralPosition, ()) {
    Corners first, second;
    for (Corners* corners : {&first, &second}) {
        for (Vec3& corner : *corners)
            corner = testing_support::random_point({Vec3::Constant(-1), Vec3::Constant(1)});
    }
    const auto exact = [](const Corners& c) {
        const auto point = [](const Vec3& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
        return Exact::Triangle_3(point(c[0]), point(c[1]), point(c[2]));
    };
    // Random corners are in general position, where meeting and crossing are the same.
    RC_ASSERT(facets_cross(first, second) == CGAL::do_intersect(exact(first), exact(second)));
    RC_ASSERT(facets_cross(first, second) == facets_cross(second, first));
}

}  // namespace
}  // namespace trocar
