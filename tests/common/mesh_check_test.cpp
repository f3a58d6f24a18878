#include "common/geometry/mesh_check.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Vertex 0 at the origin, 1 to 3 on the axes.
SurfaceMesh tetrahedron() {
    return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// Two tetrahedra, the second's vertices `shift` further; `shared` of its first vertices are the first one's.
SurfaceMesh two_tetrahedra(const Vec3& shift, Index shared) {
    SurfaceMesh mesh = tetrahedron();
    for (Index v = shared; v < 4; ++v) mesh.positions.emplace_back(tetrahedron().positions[v] + shift);
    for (Facet facet : tetrahedron().facets) {
        for (Index& vertex : facet) vertex = vertex < shared ? vertex : vertex + 4 - shared;
        mesh.facets.push_back(facet);
    }
    return mesh;
}

std::string refusals(SurfaceMesh mesh) {
    const SurfaceMesh before = mesh;
    const MeshReport report = check_mesh(mesh);
    EXPECT_EQ(before.positions.size(), mesh.positions.size());
    EXPECT_EQ(before.facets, mesh.facets) << "a refused mesh is left as it was";
    std::string all;
    for (const Finding& finding : report.findings) {
        if (finding.severity == Finding::Severity::refused) all += describe(finding) + "\n";
    }
    return all;
}

TEST(MeshCheck, MeasuresAClosedMeshAndLeavesItAlone) {
    SurfaceMesh mesh = tetrahedron();
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.usable());
    EXPECT_THAT(report.findings, IsEmpty());
    EXPECT_EQ(mesh.positions, tetrahedron().positions);
    EXPECT_EQ(mesh.facets, tetrahedron().facets);
    EXPECT_EQ(report.vertices, 4U);
    EXPECT_EQ(report.edges, 6U);
    EXPECT_EQ(report.facets, 4U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.genus, 0);
    EXPECT_DOUBLE_EQ(report.volume.value(), 1.0 / 6);
    EXPECT_DOUBLE_EQ(report.area, 1.5 + std::sqrt(3) / 2);
    EXPECT_DOUBLE_EQ(report.shortest_edge, 1);
    EXPECT_DOUBLE_EQ(report.longest_edge, std::sqrt(2));
    EXPECT_EQ(report.box.high, Vec3(1, 1, 1));
}

TEST(MeshCheck, AllowsAnOpenSheetAndNotesItsBorder) {
    SurfaceMesh mesh = make_organ_by_formula("sheet@40mm").rest;
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.usable());
    EXPECT_FALSE(report.closed);
    EXPECT_FALSE(report.volume.has_value());
    EXPECT_FALSE(report.genus.has_value());
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_EQ(report.findings[0].what, "border edges (the surface is open): 13");
}

TEST(MeshCheck, CountsTheHolesOfATorus) {
    constexpr Index n = 6;
    SurfaceMesh torus;
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
            const double along = 2 * M_PI * i / n, around = 2 * M_PI * j / n;
            const double r = 3 + std::cos(around);
            torus.positions.emplace_back(r * std::cos(along), r * std::sin(along), std::sin(around));
            const auto at = [&](Index di, Index dj) { return (i + di) % n * n + (j + dj) % n; };
            torus.facets.push_back({at(0, 0), at(1, 0), at(1, 1)});
            torus.facets.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    }
    const MeshReport report = check_mesh(torus);
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(report.genus, 1);
    EXPECT_THAT(report.findings, IsEmpty());
}

TEST(MeshCheck, TurnsAMeshThatIsInsideOut) {
    SurfaceMesh mesh = tetrahedron();
    for (Facet& facet : mesh.facets) std::swap(facet[1], facet[2]);
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(mesh.facets, tetrahedron().facets);
    EXPECT_DOUBLE_EQ(report.volume.value(), 1.0 / 6);
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_EQ(report.findings[0].severity, Finding::Severity::mended);
    EXPECT_THAT(report.findings[0].what, HasSubstr("inside out"));
}

TEST(MeshCheck, DropsVerticesThatNoFacetNames) {
    SurfaceMesh mesh = tetrahedron();
    mesh.positions.insert(mesh.positions.begin() + 1, Vec3(7, 8, 9));
    for (Facet& facet : mesh.facets) {
        for (Index& vertex : facet) vertex += vertex >= 1 ? 1 : 0;
    }
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(mesh.positions, tetrahedron().positions);
    EXPECT_EQ(mesh.facets, tetrahedron().facets);
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_EQ(describe(report.findings[0]),
              "mended: vertices that no facet names, dropped: 1; vertex 1 at (7, 8, 9)");
    EXPECT_EQ(report.box.high, Vec3(1, 1, 1)) << "the dropped vertex is not in the box";
}

TEST(MeshCheck, RefusesEdgesWithThreeFacets) {
    SurfaceMesh mesh = tetrahedron();
    mesh.positions.emplace_back(1, 1, -1);
    mesh.facets.push_back({0, 1, 4});
    EXPECT_THAT(refusals(mesh), HasSubstr("edges with more than two facets (not manifold): 1; "
                                          "edge 0–1 of facet 0 at (0.5, 0, 0)"));
}

TEST(MeshCheck, RefusesSurfacesThatTouchInAVertexOrAnEdge) {
    const std::string at_vertex = refusals(two_tetrahedra({-1, -1, -1}, 1));
    EXPECT_THAT(at_vertex, HasSubstr("only touch (not manifold): 1; vertex 0 at (0, 0, 0)"));
    EXPECT_THAT(at_vertex, Not(HasSubstr("components"))) << "they do touch";
    EXPECT_THAT(refusals(two_tetrahedra({0, -1, -1}, 2)), HasSubstr("edges with more than two facets"));
}

TEST(MeshCheck, RefusesFacetsOrientedAgainstEachOther) {
    SurfaceMesh mesh = tetrahedron();
    std::swap(mesh.facets[2][0], mesh.facets[2][1]);
    EXPECT_THAT(refusals(mesh), HasSubstr("oriented against each other: 3; edge 1–2 of facet 0"));
}

TEST(MeshCheck, RefusesFacetsWithoutArea) {
    SurfaceMesh mesh = tetrahedron();
    mesh.positions[3] = {0.5, 0, 0};
    EXPECT_THAT(refusals(mesh), HasSubstr("facets without area: 1; facet 1 at (0.5, 0, 0)"));
}

TEST(MeshCheck, KeepsVeryThinFacets) {
    SurfaceMesh mesh = tetrahedron();
    mesh.positions[3] = {0.5, 0, 1e-9};
    EXPECT_TRUE(check_mesh(mesh).usable());
}

TEST(MeshCheck, RefusesTheSameFacetTwice) {
    SurfaceMesh mesh = tetrahedron();
    mesh.facets.push_back({3, 1, 2});
    EXPECT_THAT(refusals(mesh), HasSubstr("facets with the same vertices as another one: 1; facet 4 at"));
    mesh.facets[4] = {2, 1, 3};
    EXPECT_THAT(refusals(mesh), HasSubstr("facet 4 at")) << "also when it is turned around";
}

TEST(MeshCheck, RefusesAVertexTwiceInAFacet) {
    SurfaceMesh mesh = tetrahedron();
    mesh.facets.push_back({3, 1, 3});
    EXPECT_EQ(refusals(mesh), "refused: facets that name a vertex twice: 1; facet 4 (3, 1, 3)\n");
}

TEST(MeshCheck, RefusesVerticesThatDoNotExist) {
    SurfaceMesh mesh = tetrahedron();
    mesh.facets.push_back({3, 1, 4});
    mesh.facets.push_back({3, 1, -1});
    EXPECT_EQ(
        refusals(mesh),
        "refused: facets that name a vertex that does not exist: 2; facet 4 (3, 1, 4), facet 5 (3, 1, -1)\n");
}

TEST(MeshCheck, RefusesCoordinatesThatAreNotFinite) {
    SurfaceMesh mesh = tetrahedron();
    mesh.positions[2].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusals(mesh), "refused: vertices with a coordinate that is not finite: 1; vertex 2\n");
}

TEST(MeshCheck, RefusesSeveralComponentsAndSaysHowLargeTheyAre) {
    SurfaceMesh mesh = two_tetrahedra({5, 0, 0}, 0);
    mesh.facets.pop_back();
    EXPECT_EQ(refusals(mesh),
              "refused: components that do not touch: 2 instead of one; facets in each: 4, 3\n");
}

TEST(MeshCheck, RefusesAMeshWithoutFacets) { EXPECT_EQ(refusals({}), "refused: the mesh has no facet\n"); }

TEST(MeshCheck, NamesTheFirstFewPlacesOnly) {
    SurfaceMesh mesh = tetrahedron();
    for (int i = 0; i < 5; ++i) mesh.facets.push_back({0, 0, 0});
    EXPECT_EQ(refusals(mesh),
              "refused: facets that name a vertex twice: 5; facet 4 (0, 0, 0), facet 5 (0, 0, 0), "
              "facet 6 (0, 0, 0), and 2 more\n");
}

TEST(MeshReport, ReadsAsText) {
    SurfaceMesh mesh = tetrahedron();
    EXPECT_EQ(
        describe(check_mesh(mesh)),
        "vertices    4\nedges       6\nfacets      4\ncomponents  1\nsurface     closed\ngenus       0\n"
        "box         1 × 1 × 1 mm, from (0, 0, 0) to (1, 1, 1)\n"
        "edges long  1 to 1.414 mm, median 1.414 mm\narea        2.36603 mm²\nvolume      0.166667 mm³\n"
        "This mesh can be used.\n");
    mesh.facets.push_back({0, 0, 0});
    EXPECT_THAT(describe(check_mesh(mesh)), HasSubstr("cannot be used"));
}

}  // namespace
}  // namespace trocar
