#include "common/geometry/solid.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/surface_queries.h"
#include "common/tool/tool_shapes.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing::HasSubstr;
using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

/// A square tool, 8 mm wide (corners on a circle of radius 4 √2), 10 mm long: known answers by hand.
Tool square_tool() { return make_prism(4, 4 * std::numbers::sqrt2, 10); }

Vec3 random_point_around(const Tool& tool) { return random_point(tool.solid.box().grown(1)); }

TEST(Solid, CountsCoplanarFacetsAsOneFace) {
    EXPECT_EQ(square_tool().solid.face_count(), 6U);
    EXPECT_EQ(make_prism(12).solid.face_count(), 14U);
    EXPECT_EQ(make_prism(64).solid.face_count(), 66U);
}

std::string message_of(const SurfaceMesh& mesh) {
    try {
        const Solid solid(mesh);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "it was accepted";
}

TEST(Solid, RefusesWhatIsNotClosedAndOutward) {
    SurfaceMesh open = square_tool().mesh;
    open.facets.pop_back();
    EXPECT_THAT(message_of(open), HasSubstr("boundary"));
    EXPECT_THAT(message_of({}), HasSubstr("boundary"));

    SurfaceMesh inward = square_tool().mesh;
    for (Facet& facet : inward.facets) std::swap(facet[0], facet[1]);
    EXPECT_THAT(message_of(inward), HasSubstr("counter-clockwise"));
}

TEST(Solid, RefusesASurfaceThatMeetsItself) {
    SurfaceMesh folded = make_prism(6, 4, 10).mesh;
    folded.positions[0].x() = -6;  // through the side across
    EXPECT_THAT(message_of(folded), HasSubstr("must not meet itself; facets "));
}

TEST(Solid, KnowsWhetherItIsConvex) {
    for (const char* convex : {"prism-3", "prism-12", "prism-64", "pointed-prism-5", "needle"}) {
        EXPECT_TRUE(make_tool_by_formula(convex).solid.convex()) << convex;
    }
    EXPECT_FALSE(make_grasper().solid.convex());
    SurfaceMesh dented = make_prism(6).mesh;
    dented.positions.front() *= 0.5;
    EXPECT_FALSE(Solid(dented).convex());
    // One corner of an end, further in or out than the other ones by nearly nothing.
    SurfaceMesh bent = make_prism(6).mesh;
    bent.positions[1].z() = 1e-300;
    EXPECT_TRUE(Solid(bent).convex()) << "the corner is cut";
    bent.positions[1].z() = -1e-300;
    EXPECT_FALSE(Solid(bent).convex()) << "the edge across is a valley";
}

TEST(Solid, CopiesShareWhatIsPrepared) {
    const Solid original(square_tool().mesh);
    Solid copy = original;
    EXPECT_EQ(&copy.box(), &original.box());
    const Solid moved = std::move(copy);
    EXPECT_TRUE(moved.contains({0, 0, 5}));
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

TEST(Solid, OfEquallyNearFacesTheLowestCounts) {
    const Tool tool = square_tool();
    for (const double off : {0.0, 1e-13, -1e-13}) {  // as rounding of the coordinates would have it
        EXPECT_EQ(tool.solid.nearest_face({3 + off, 0, 5}).face, 0) << off;
        EXPECT_EQ(tool.solid.nearest_face({3, off, 5}).face, 0) << off;
        EXPECT_EQ(tool.solid.closest({3, off, 5}).facet, tool.solid.closest({3, 0, 5}).facet) << off;
    }
}

TEST(Solid, BetweenTheJawsTheNearestFaceIsTheLowerNumber) {
    const Tool tool = make_grasper();
    for (const double off : {0.0, 1e-13, -1e-13}) {
        const NearestFace nearest = tool.solid.nearest_face({0, off, 8});
        EXPECT_EQ(nearest.face, tool.solid.nearest_face({0, 0, 8}).face) << off;
        EXPECT_LT(nearest.normal.y(), 0) << "the inner face of the jaw at +y comes first";
    }
}

RC_GTEST_PROP(Solid, NearestFaceOfAGrasperCarriesTheClosestPoint, ()) {
    static const Tool tool = make_grasper();
    static const SurfaceQueries oracle(tool.mesh);
    const Vec3 point = random_point(Box{{-4, -9, -1}, {4, 9, 25}});
    const NearestFace nearest = tool.solid.nearest_face(point);
    const double distance = oracle.distance(point);
    RC_ASSERT(std::abs(nearest.signed_distance - (oracle.contains(point) ? -distance : distance)) < 1e-9);
    const SurfacePoint closest = tool.solid.closest(point);
    RC_ASSERT(closest.normal == nearest.normal);
    RC_ASSERT(closest.normal.isApprox(facet_normal(tool.mesh.positions, tool.mesh.facets[closest.facet])));
    const Vec3 corner = tool.mesh.positions[tool.mesh.facets[closest.facet][0]];
    RC_ASSERT(std::abs(nearest.normal.dot(closest.position - corner)) < 1e-9);
}

RC_GTEST_PROP(Solid, ClosestPointIsAsFarAsCgalsTreeSays, ()) {
    static const std::array tools{make_prism(5, 4, 10), make_needle(), make_grasper()};
    static const std::array oracles{SurfaceQueries(tools[0].mesh), SurfaceQueries(tools[1].mesh),
                                    SurfaceQueries(tools[2].mesh)};
    const auto which = *rc::gen::inRange<std::size_t>(0, tools.size());
    const Solid& solid = tools.at(which).solid;
    const SurfaceQueries& oracle = oracles.at(which);
    const Vec3 point = random_point_around(tools.at(which));
    const Vec3 closest = solid.closest(point).position;
    RC_ASSERT(std::abs((closest - point).norm() - oracle.distance(point)) < 1e-9);
    RC_ASSERT(oracle.distance(closest) < 1e-9);
    const double reach = random_number(0, 1);
    RC_PRE(std::abs(oracle.distance(point) - reach) > 1e-9);
    RC_ASSERT(solid.within(point, reach) == (oracle.contains(point) || oracle.distance(point) <= reach));
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
