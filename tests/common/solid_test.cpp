#include "common/geometry/solid.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/surface_queries.h"
#include "common/tool/tool_shapes.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

constexpr double clearance = 0.01;

/// A square tool, 8 mm wide (corners on a circle of radius 4 √2), 10 mm long: known answers by hand.
Tool square_tool() { return make_prism(4, 4 * std::numbers::sqrt2, 10); }

Vec3 random_point_around(const Tool& tool) { return random_point(tool.solid.box().grown(1)); }

TEST(Solid, CountsCoplanarFacetsAsOneFace) {
    EXPECT_EQ(square_tool().solid.face_count(), 6U);
    EXPECT_EQ(make_prism(12).solid.face_count(), 14U);
    EXPECT_EQ(make_prism(64).solid.face_count(), 66U);
}

TEST(Solid, RefusesWhatIsNotClosedConvexAndOutward) {
    SurfaceMesh open = square_tool().mesh;
    open.facets.pop_back();
    EXPECT_THROW(Solid{open}, std::invalid_argument);

    SurfaceMesh inward = square_tool().mesh;
    for (Facet& facet : inward.facets) std::swap(facet[0], facet[1]);
    EXPECT_THROW(Solid{inward}, std::invalid_argument);

    SurfaceMesh dented = make_prism(6).mesh;
    dented.positions.front() *= 0.5;
    EXPECT_THROW(Solid{dented}, std::invalid_argument);
}

TEST(Solid, TheSurfaceIsNotInside) {
    const Tool tool = make_prism(12);
    EXPECT_TRUE(tool.solid.contains({0, 0, 1e-300}));
    EXPECT_FALSE(tool.solid.contains({0, 0, 0}));
    EXPECT_FALSE(tool.solid.contains({0, 0, -1e-300}));
    for (const Vec3& corner : tool.mesh.positions) EXPECT_FALSE(tool.solid.contains(corner));
}

RC_GTEST_PROP(Solid, ContainsWhatCgalSaysIsInside, ()) {
    static const Tool tool = make_prism(12, 4, 10);
    static const SurfaceQueries oracle(tool.mesh);
    const Vec3 point = random_point_around(tool);
    RC_ASSERT(tool.solid.contains(point) == oracle.contains(point));
}

TEST(Solid, ExitDistanceMeetsTheFaceMovedOutByTheClearance) {
    const Tool tool = square_tool();
    const Vec3 inside(0, 0, 2);
    EXPECT_DOUBLE_EQ(tool.solid.exit_distance(inside, -Vec3::UnitZ(), clearance), 2.01);
    EXPECT_DOUBLE_EQ(tool.solid.exit_distance(inside, Vec3::UnitZ(), clearance), 8.01);
    const Vec3 side =
        tool.solid.nearest_face({3.9 * std::numbers::sqrt2 / 2, 3.9 * std::numbers::sqrt2 / 2, 5}).normal;
    EXPECT_NEAR(tool.solid.exit_distance(inside, side, clearance), 4.01, 1e-12);
}

RC_GTEST_PROP(Solid, ExitIsOutsideAtTheClearanceAndNotMuchFurtherThanNeeded, ()) {
    static const Tool tool = make_prism(12, 4, 10);
    static const SurfaceQueries oracle(tool.mesh);
    const Vec3 point = random_point_around(tool);
    RC_PRE(tool.solid.contains(point));
    const Vec3 direction = random_direction();
    const double exit = tool.solid.exit_distance(point, direction, clearance);
    const Vec3 outside = point + exit * direction;
    RC_ASSERT(!oracle.contains(outside));
    RC_ASSERT(oracle.distance(outside) >= clearance - 1e-12);
    // It lies on a face moved out by g and on or below all others: at most at a right-angled corner of three.
    RC_ASSERT(oracle.distance(outside) <= clearance * std::numbers::sqrt3);
}

TEST(Solid, NearestFaceIsTheOneWithTheLeastDepth) {
    const Tool tool = square_tool();
    const NearestFace tip = tool.solid.nearest_face({0, 0, 1});
    EXPECT_TRUE(tip.normal.isApprox(-Vec3::UnitZ()));
    EXPECT_DOUBLE_EQ(tip.signed_distance, -1);
    const NearestFace handle = tool.solid.nearest_face({0, 0, 9.5});
    EXPECT_TRUE(handle.normal.isApprox(Vec3::UnitZ()));
    EXPECT_DOUBLE_EQ(handle.signed_distance, -0.5);
}

RC_GTEST_PROP(Solid, NearestFacePlaneIsAsDeepAsTheSurfaceIsFar, ()) {
    static const Tool tool = make_prism(12, 4, 10);
    static const SurfaceQueries oracle(tool.mesh);
    const Vec3 point = random_point_around(tool);
    RC_PRE(tool.solid.contains(point));
    RC_ASSERT(std::abs(tool.solid.nearest_face(point).signed_distance + oracle.distance(point)) < 1e-9);
}

RC_GTEST_PROP(Solid, ClosestPointIsAsFarAsCgalsTreeSays, ()) {
    static const Tool tool = make_prism(5, 4, 10);
    static const SurfaceQueries oracle(tool.mesh);
    const Vec3 point = random_point_around(tool);
    const Vec3 closest = tool.solid.closest_point(point);
    RC_ASSERT(std::abs((closest - point).norm() - oracle.distance(point)) < 1e-9);
    RC_ASSERT(oracle.distance(closest) < 1e-9);
    const double reach = random_number(0, 1);
    const bool near = oracle.contains(point) || oracle.distance(point) <= reach;
    RC_PRE(std::abs(oracle.distance(point) - reach) > 1e-9);
    RC_ASSERT(tool.solid.within(point, reach) == near);
}

RC_GTEST_PROP(Solid, SupportIsTheFurthestVertex, ()) {
    static const Tool tool = make_prism(7);
    const Vec3 direction = random_direction();
    const double reach = tool.solid.support(direction).dot(direction);
    for (const Vec3& corner : tool.mesh.positions) RC_ASSERT(corner.dot(direction) <= reach);
}

RC_GTEST_PROP(Solid, IsCrossedByFacetsThatCrossOneOfItsOwn, ()) {
    static const Tool tool = make_prism(12, 4, 10);
    Corners facet;
    facet[0] = random_point_around(tool);
    for (int k = 1; k < 3; ++k) facet[k] = facet[0] + random_number(0.1, 6) * random_direction();
    bool crosses = false;
    for (const auto& [a, b, c] : tool.mesh.facets) {
        const auto& p = tool.mesh.positions;
        // In general position no organ edge meets an edge of the tool, so flat edges do not matter.
        crosses = crosses || facets_cross(facet, {p[a], p[b], p[c]});
    }
    RC_ASSERT(tool.solid.crossed_by(facet[0], facet[1], facet[2]) == crosses);
}

TEST(Solid, AFacetThroughTheDiagonalOfAnEndCrosses) {
    const Tool tool = square_tool();
    // Its edge along the axis passes exactly through the diagonal that splits the flat end.
    EXPECT_TRUE(tool.solid.crossed_by({0, 0, -1}, {0, 0, 1}, {1, 1, -1}));
    EXPECT_FALSE(tool.solid.crossed_by({0, 0, -1}, {0, 0, 0}, {1, 1, -1})) << "it only touches";
}

}  // namespace
}  // namespace trocar
