// What OrganShape::make promises, for every shape of the list.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/geometry/mesh_check.h"
#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

struct Case {
    const OrganShape* shape;
    double edge, size;
};

void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.shape->name << ", edge " << tested.edge << " mm, size " << tested.size << " mm";
}

// Of every shape: its longest edge, two shorter ones, and another size. Then lengths at which the remesher's
// first good-looking answer has a bad edge or (the gallbladder) meets itself.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (const OrganShape& shape : all_organ_shapes()) {
        const double size = shape.default_size, longest = shape.longest_edge;
        for (const double edge : {longest, 0.5 * longest, std::min(4.0, 0.3 * longest)}) {
            all.push_back({&shape, edge, size});
        }
        all.push_back({&shape, 0.75 * longest, 1.5 * size});
        if (shape.name == "gallbladder") all.push_back({&shape, 4.76, size});
        if (shape.name == "tube") all.push_back({&shape, 8.74, size});
        if (shape.name == "liver") all.push_back({&shape, 5.95, size});
        if (shape.name == "cleft") all.push_back({&shape, 6.13, size});
    }
    return all;
}

bool meets_itself(const SurfaceMesh& mesh) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
    CgalMesh copy;
    for (const Vec3& p : mesh.positions) copy.add_vertex({p.x(), p.y(), p.z()});
    using Vertex = CgalMesh::Vertex_index;
    for (const auto& [a, b, c] : mesh.facets) copy.add_face(Vertex(a), Vertex(b), Vertex(c));
    EXPECT_EQ(copy.number_of_faces(), mesh.facets.size());
    return CGAL::Polygon_mesh_processing::does_self_intersect(copy);
}

double smallest_angle(const SurfaceMesh& mesh) {
    double smallest = std::numbers::pi;
    for (const Facet& facet : mesh.facets) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& corner = mesh.positions[facet[k]];
            const Vec3 one = mesh.positions[facet[(k + 1) % 3]] - corner;
            const Vec3 other = mesh.positions[facet[(k + 2) % 3]] - corner;
            smallest = std::min(smallest, std::atan2(one.cross(other).norm(), one.dot(other)));
        }
    }
    return smallest * 180 / std::numbers::pi;
}

class OrganQuality : public testing::TestWithParam<Case> {};

TEST_P(OrganQuality, IsAsPromised) {
    const auto& [shape, edge, size] = GetParam();
    Organ organ = shape->make("organ", edge, size);
    EXPECT_EQ(organ.name, "organ");
    EXPECT_EQ(organ.adjacency.closed(), !organ.outline.has_value()) << "only sheets are open";
    EXPECT_FALSE(meets_itself(organ.rest));
    EXPECT_GE(smallest_angle(organ.rest), 10);
    for (const auto& [a, b] : organ.adjacency.edges()) {
        const double length = (organ.rest.positions[a] - organ.rest.positions[b]).norm();
        ASSERT_GE(length, 0.5 * edge * (1 - 1e-12));
        ASSERT_LE(length, 2 * edge);
    }
    const Box box = bounding_box(organ.rest.positions);
    EXPECT_NEAR(box.size().maxCoeff(), size, 0.08 * size + 0.25 * edge);
    EXPECT_LE(box.centre().norm(), 0.05 * size);

    const MeshReport report = check_mesh(organ.rest);
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.vertices, organ.adjacency.edges().size() + 2 - report.facets -
                                   (report.closed ? 2 * report.genus.value_or(-1) : 1))
        << "Euler";
    EXPECT_EQ(report.genus.value_or(0), shape->name == "tube" ? 1 : 0);
}
INSTANTIATE_TEST_SUITE_P(Shapes, OrganQuality, testing::ValuesIn(cases()), [](const auto& tested) {
    std::string name =
        fmt::format("{}_{}_{}", tested.param.shape->name, tested.param.edge, tested.param.size);
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
});

TEST(OrganShapes, GiveTheSameBitsEachTime) {
    for (const OrganShape& shape : all_organ_shapes()) {
        const double edge = shape.longest_edge / 2;
        const Organ one = shape.make("one", edge, shape.default_size);
        const Organ other = shape.make("other", edge, shape.default_size);
        EXPECT_EQ(one.rest.facets, other.rest.facets) << shape.name;
        ASSERT_EQ(one.rest.positions.size(), other.rest.positions.size()) << shape.name;
        const std::size_t bytes = one.rest.positions.size() * sizeof(Vec3);
        EXPECT_EQ(std::memcmp(one.rest.positions.data(), other.rest.positions.data(), bytes), 0)
            << shape.name;
    }
}

TEST(OrganShapes, AreSimilarAtEverySize) {
    for (const OrganShape& shape : all_organ_shapes()) {
        const double edge = shape.longest_edge / 2, size = shape.default_size;
        const Organ one = shape.make("one", edge, size);
        const Organ twice = shape.make("twice", 2 * edge, 2 * size);
        EXPECT_EQ(one.rest.facets, twice.rest.facets) << shape.name;
        for (std::size_t v = 0; v < one.rest.positions.size(); ++v) {
            ASSERT_LE((2 * one.rest.positions[v] - twice.rest.positions[v]).norm(), 1e-9 * size)
                << shape.name;
        }
    }
}

}  // namespace
}  // namespace trocar
