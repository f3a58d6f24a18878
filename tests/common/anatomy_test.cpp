// What is particular to each of the shapes that are more than a sheet or a sphere.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "common/geometry/mesh_topology.h"
#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

double mean_edge(const Organ& organ) {
    double sum = 0;
    for (const auto& [a, b] : organ.adjacency.edges()) {
        sum += (organ.rest.positions[a] - organ.rest.positions[b]).norm();
    }
    return sum / static_cast<double>(organ.adjacency.edges().size());
}

// The angle in degrees by which the surface turns at each of its inner edges.
std::vector<double> turns(const Organ& organ) {
    std::vector<double> angles;
    for_each_edge(edge_uses(organ.rest.facets), [&](std::span<const EdgeUse> uses) {
        if (uses.size() < 2) return;
        const double cosine = organ.rest_normals[uses[0].facet].dot(organ.rest_normals[uses[1].facet]);
        angles.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
    });
    std::ranges::sort(angles);
    return angles;
}

// Where a straight line meets the surface: the distances from `from`, ascending.
std::vector<double> piercings(const Organ& organ, const Vec3& from, const Vec3& direction) {
    std::vector<double> distances;
    for (const Facet& facet : organ.rest.facets) {
        Mat3 matrix;
        const Vec3& a = organ.rest.positions[facet[0]];
        matrix << direction, a - organ.rest.positions[facet[1]], a - organ.rest.positions[facet[2]];
        const Vec3 solution = matrix.inverse() * (a - from);  // distance and barycentric coordinates
        if (solution[1] >= 0 && solution[2] >= 0 && solution[1] + solution[2] <= 1 && solution[0] > 0) {
            distances.push_back(solution[0]);
        }
    }
    std::ranges::sort(distances);
    return distances;
}

class RoughSheet : public testing::TestWithParam<const char*> {};

TEST_P(RoughSheet, HasOutlineAndMeanEdgeOfTheSheet) {
    const Organ rough = make_organ_by_formula("rough-sheet@" + std::string(GetParam()));
    const Organ sheet = make_organ_by_formula("sheet@" + std::string(GetParam()));
    EXPECT_NEAR(mean_edge(rough), mean_edge(sheet), 1e-6);
    ASSERT_TRUE(rough.outline.has_value());
    EXPECT_EQ(rough.outline->half_x, sheet.outline->half_x);
    EXPECT_EQ(rough.outline->half_y, sheet.outline->half_y);
    for (std::size_t v = 0; v < rough.rest.positions.size(); ++v) {
        const Vec3& p = rough.rest.positions[v];
        const bool at_side = std::max(std::abs(p.x()), std::abs(p.y())) == 60;
        EXPECT_EQ(rough.adjacency.on_boundary(static_cast<Index>(v)), at_side);
        EXPECT_EQ(at_side ? p.z() : 0, 0);
    }
}

TEST_P(RoughSheet, LiesOnceAboveEachPointOfItsOutline) {
    const Organ rough = make_organ_by_formula("rough-sheet@" + std::string(GetParam()));
    double area = 0;
    for (std::size_t f = 0; f < rough.rest.facets.size(); ++f) {
        EXPECT_GT(rough.rest_normals[f].z(), 0.2);
        area += rough.rest_normals[f].z() * rough.rest_areas[f];
    }
    EXPECT_NEAR(area, 120 * 120, 1e-7);
}

TEST_P(RoughSheet, IsRoughAndIrregular) {
    const Organ rough = make_organ_by_formula("rough-sheet@" + std::string(GetParam()));
    const std::vector<double> angles = turns(rough);
    EXPECT_GT(angles[angles.size() / 2], 10) << "tens of degrees at many of the edges";
    EXPECT_GT(angles[angles.size() * 9 / 10], 30);
    EXPECT_GT(bounding_box(rough.rest.positions).size().z(), 6);
    std::vector<double> areas = rough.rest_areas;
    std::ranges::sort(areas);
    EXPECT_GT(areas[areas.size() * 9 / 10], 1.5 * areas[areas.size() / 10]);
    std::size_t irregular = 0;
    for (std::size_t v = 0; v < rough.rest.positions.size(); ++v) {
        irregular += rough.adjacency.neighbours(static_cast<Index>(v)).size() == 6 ? 0 : 1;
    }
    EXPECT_GT(irregular, rough.rest.positions.size() / 20);
}
INSTANTIATE_TEST_SUITE_P(Edges, RoughSheet, testing::Values("12mm", "8mm", "4mm", "2.3mm"),
                         [](const auto& tested) { return "Case" + std::to_string(tested.index); });

TEST(Tube, HasAHollowAllAlong) {
    const Organ tube = make_organ_by_formula("tube@4mm");
    // Across the middle: wall, hollow, wall.
    const std::vector<double> across = piercings(tube, {-100, 0.13, 0.21}, Vec3::UnitX());
    ASSERT_EQ(across.size(), 4U);
    EXPECT_NEAR(across[1] - across[0], 4, 0.4);
    EXPECT_NEAR(across[3] - across[2], 4, 0.4);
    EXPECT_NEAR(across[3] - across[0], 40, 2);
    // The axis, an arc, meets nothing.
    for (const double z : {-70.0, -35.0, 35.0, 70.0}) {
        const double x = std::sqrt(220 * 220 - z * z) - 215;
        const Vec3 centre(x, 0.1, z);
        EXPECT_EQ(piercings(tube, centre, Vec3::UnitY()).size(), 2U) << z;
        EXPECT_GT(piercings(tube, centre, Vec3::UnitY()).front(), 12) << z;
    }
    EXPECT_NEAR(bounding_box(tube.rest.positions).size().z(), 155, 5);
}

TEST(Gallbladder, IsAPear) {
    const Organ organ = make_organ_by_formula("gallbladder@2mm");
    const Vec3 size = bounding_box(organ.rest.positions).size();
    EXPECT_NEAR(size.z(), 80, 1.5);
    EXPECT_NEAR(size.y(), 35, 1.5);
    const auto width = [&](double z) {
        const std::vector<double> across = piercings(organ, {-100, 0.07, z}, Vec3::UnitX());
        EXPECT_EQ(across.size(), 2U) << z;
        return across.back() - across.front();
    };
    EXPECT_NEAR(width(-12.3), 35, 1);
    EXPECT_NEAR(width(29.7), 12, 2) << "the neck";
    EXPECT_GT(width(-30.1), width(20.1)) << "the fundus is wider than the neck";
    EXPECT_NEAR(signed_volume(organ.rest) / 1000, 42, 2) << "ml; textbooks give 30 to 50";
}

TEST(Liver, HasLobesAsThickAsTheyShouldBe) {
    const Organ organ = make_organ_by_formula("liver@4mm");
    const Vec3 size = bounding_box(organ.rest.positions).size();
    EXPECT_NEAR(size.x(), 200, 4);
    const auto thickness = [&](double x, double y) {
        const std::vector<double> through = piercings(organ, {x, y, -200}, Vec3::UnitZ());
        EXPECT_EQ(through.size(), 2U) << x << ", " << y;
        return through.back() - through.front();
    };
    EXPECT_GT(thickness(-40.1, 5.2), 60) << "right lobe";
    EXPECT_LT(thickness(75.1, 1.2), 25) << "left lobe";
    EXPECT_TRUE(piercings(organ, {22, -28, -200}, Vec3::UnitZ()).empty()) << "the notch";
    EXPECT_FALSE(piercings(organ, {5, -28, -200}, Vec3::UnitZ()).empty());
    EXPECT_FALSE(piercings(organ, {40, -28, -200}, Vec3::UnitZ()).empty());
}

// The lowest vertex at each place from side to side is one at which two facets meet at an acute angle.
TEST(Liver, HasASharpLowerEdge) {
    for (const char* formula : {"liver@8mm", "liver@4mm"}) {
        const Organ organ = make_organ_by_formula(formula);
        for (const double x : {-60.0, -40.0, -10.0, 45.0, 60.0}) {
            Index lowest = 0;
            double height = 1e9;
            for (std::size_t v = 0; v < organ.rest.positions.size(); ++v) {
                const Vec3& p = organ.rest.positions[v];
                if (std::abs(p.x() - x) > 5 || p.z() > height) continue;
                height = p.z();
                lowest = static_cast<Index>(v);
            }
            const std::span<const Index> ring = organ.adjacency.ring(lowest);
            double least = 1;  // cosine of the angle between neighbouring facets' normals
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Vec3& next = organ.rest_normals[ring[(k + 1) % ring.size()]];
                least = std::min(least, organ.rest_normals[ring[k]].dot(next));
            }
            EXPECT_LT(least, 0) << formula << " at x = " << x;
        }
    }
}

class Cleft : public testing::TestWithParam<const char*> {};

TEST_P(Cleft, HasTwoWallsThreeMillimetresApart) {
    const Organ organ = make_organ_by_formula(GetParam());
    ASSERT_TRUE(organ.mouth.has_value());
    const auto& [point, normal, along, length] = *organ.mouth;
    EXPECT_GE(length, 60);
    const Vec3 across(along.y() * normal.z() - along.z() * normal.y(),
                      along.z() * normal.x() - along.x() * normal.z(),
                      along.x() * normal.y() - along.y() * normal.x());
    for (const double place : {-0.42, -0.21, 0.03, 0.33, 0.42}) {
        for (const double depth : {10.3, 17.3, 24.3}) {
            const Vec3 inside = point + place * length * along - depth * normal;
            const double gap =
                piercings(organ, inside, across).front() + piercings(organ, inside, -across).front();
            EXPECT_NEAR(gap, 3, 0.4) << place << ", " << depth;
        }
        // From the mouth straight down to the bottom, straight up to nothing.
        const Vec3 at = point + place * length * along + 0.01 * across;
        EXPECT_NEAR(piercings(organ, at, -normal).front(), 35, 0.5);
        EXPECT_TRUE(piercings(organ, at, normal).empty());
    }
    EXPECT_EQ(make_organ_by_formula("sphere").mouth.has_value(), false);
}
INSTANTIATE_TEST_SUITE_P(Edges, Cleft, testing::Values("cleft@8mm", "cleft@4mm", "cleft@2mm"),
                         [](const auto& tested) { return "Case" + std::to_string(tested.index); });

}  // namespace
}  // namespace trocar
