#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/surface_queries.h"
#include "tests/strategies/scenes.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

/// How nearest-face moves a vertex inside an upright square tool (sides 2 √2 mm from the axis) with its tip
/// at the origin.
Vec3 moved_from(const Vec3& inside) {
    const std::vector<Vec3> corners = {inside + Vec3(1, 0, 0), inside + Vec3(0, 1, 0),
                                       inside + Vec3(-1, -1, 0)};
    const Response response =
        contract::answer_of("nearest-face", contract::single_vertex(inside, corners, {0, 0, -1}));
    EXPECT_EQ(response.displacements.size(), 1U);
    return response.displacements.at(0).displacement;
}

TEST(NearestFace, NearTheTipGoesOutThroughTheTip) {
    EXPECT_TRUE(moved_from({0.1, 0.2, 1}).isApprox(Vec3(0, 0, -1.01), 1e-12));
}

TEST(NearestFace, FurtherUpGoesOutThroughTheNearestSide) {
    // The side x + y = 4: the vertex at (1.5, 1.5) is 1 / √2 below it.
    const double along = (std::numbers::sqrt2 / 2 + 0.01) / std::numbers::sqrt2;
    EXPECT_TRUE(moved_from({1.5, 1.5, 7}).isApprox(Vec3(along, along, 0), 1e-12));
}

TEST(NearestFace, ARapidToolPushesNothingAheadOfItsTip) {
    // The paper's Fig. 5b: deep inside, the tip is never the nearest face.
    EXPECT_EQ(moved_from({1.5, 1.5, 7}).z(), 0);
}

/// A bar along z with the section of an L: a corner of 4 mm by 4 mm with a quarter missing, and so a
/// re-entrant edge at (2, 2).
Tool make_l_bar() {
    const std::vector<Vec3> section = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}};
    SurfaceMesh mesh;
    for (const Vec3& corner : section) mesh.positions.push_back(corner);
    for (const Vec3& corner : section) mesh.positions.emplace_back(corner + Vec3(0, 0, 80));
    for (Index k = 0; k < 6; ++k) {
        const Index next = (k + 1) % 6;
        mesh.facets.push_back({k, next, next + 6});
        mesh.facets.push_back({k, next + 6, k + 6});
    }
    for (const Facet& f : {Facet{3, 0, 1}, Facet{3, 1, 2}, Facet{3, 4, 5}, Facet{3, 5, 0}}) {
        mesh.facets.push_back({f[0], f[2], f[1]});
        mesh.facets.push_back({f[0] + 6, f[1] + 6, f[2] + 6});
    }
    return make_tool("L", std::move(mesh));
}

Vec3 moved_in_l_bar(const Vec3& inside) {
    auto scene = contract::single_vertex(inside, contract::flat_base(inside), {0, 0, -1});
    scene.tool = std::make_shared<const Tool>(make_l_bar());
    return contract::answer_of("nearest-face", scene).displacements.at(0).displacement;
}

TEST(NearestFace, InANonConvexToolGoesToTheClosestPointOfTheSurface) {
    EXPECT_TRUE(moved_in_l_bar({3.25, 1.5, 40}).isApprox(Vec3(0, 0.51, 0), 1e-12));
    EXPECT_TRUE(moved_in_l_bar({0.25, 3, 40}).isApprox(Vec3(-0.26, 0, 0), 1e-12));
    EXPECT_TRUE(moved_in_l_bar({1, 1.5, 0.5}).isApprox(Vec3(0, 0, -0.51), 1e-12));
}

TEST(NearestFace, InANonConvexToolMayLeaveThroughAReentrantEdge) {
    // (1.6, 1.6) is 0.4 √2 from the edge at (2, 2); at (2 + g, 2 + g) both walls are g away.
    EXPECT_TRUE(moved_in_l_bar({1.6, 1.6, 40}).isApprox(Vec3(0.41, 0.41, 0), 1e-12));
}

TEST(NearestFace, OnTheSurfaceTakesTheFacetsNormal) {
    // Turned and far away, so that the way to the surface is nothing but rounding.
    const Vec3 inside(3, 2 - 1e-13, 40);
    auto scene = contract::single_vertex(inside, contract::flat_base(inside), {0, 0, -1});
    scene.tool = std::make_shared<const Tool>(make_l_bar());
    scene = contract::moved(scene, {.rotation = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).matrix(),
                                    .position = {300, -200, 100}});
    const Vec3 found = contract::answer_of("nearest-face", scene).displacements.at(0).displacement;
    EXPECT_TRUE(found.isApprox(scene.after.rotation * Vec3(0, 0.01, 0), 1e-9)) << found.transpose();
}

RC_GTEST_PROP(NearestFace, InAGrasperTakesTheShortestWayToTheSurface, (std::uint32_t seed)) {
    const contract::Scene scene = contract::random_scene(seed, "grasper");
    const SurfaceQueries surface(scene.tool->mesh);
    for (const auto& [vertex, displacement] : contract::answer_of("nearest-face", scene).displacements) {
        const Vec3 start = judged_position(scene.after, scene.positions[vertex]);
        const Vec3 end = judged_position(scene.after, scene.positions[vertex] + displacement);
        const double shortest = surface.distance(start);
        const Vec3 on_surface = start + shortest * (end - start).normalized();
        RC_ASSERT(surface.distance(on_surface) < 1e-9);
        RC_ASSERT(std::abs(surface.distance(end) - scene.clearance) < 1e-9);
    }
}

}  // namespace
}  // namespace trocar
