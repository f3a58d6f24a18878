// The searches of a FacetTree against all facets, one by one, and against CGAL's tree.

#include "common/geometry/facet_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/closest_search.h"
#include "common/geometry/exit_search.h"
#include "common/geometry/inside_test.h"
#include "common/geometry/organ_shapes.h"
#include "common/geometry/surface_queries.h"
#include "common/geometry/triangle_distance.h"
#include "common/tool/tool_shapes.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

constexpr double rounding = 1e-10;

/// An L of 4 by 4 mm, 2 mm wide and 3 mm high, whose corners have whole coordinates. It is turned until its
/// height is along an axis.
SurfaceMesh angle_iron(int along) {
    SurfaceMesh mesh;
    for (const double z : {0.0, 3.0}) {
        for (const auto& [x, y] : {std::array{0., 0.}, {4., 0.}, {4., 2.}, {2., 2.}, {2., 4.}, {0., 4.}}) {
            Vec3 position;
            position[(along + 1) % 3] = x;
            position[(along + 2) % 3] = y;
            position[along] = z;
            mesh.positions.push_back(position);
        }
    }
    for (Index k = 1; k < 5; ++k) {
        mesh.facets.push_back({0, k + 1, k});
        mesh.facets.push_back({6, k + 6, k + 7});
    }
    for (Index k = 0; k < 6; ++k) {
        const Index next = (k + 1) % 6;
        mesh.facets.push_back({k, next, next + 6});
        mesh.facets.push_back({k, next + 6, k + 6});
    }
    return mesh;
}

TEST(InsideTest, KnowsEveryPlaceOfALatticeThroughASolidsCorners) {
    // Facets, edges and corners on the ray, and the point on each of them.
    for (int along = 0; along < 3; ++along) {
        const SurfaceMesh mesh = angle_iron(along);
        ASSERT_DOUBLE_EQ(signed_volume(mesh), 36);
        const FacetTree tree(mesh);
        for (int i = -1; i <= 9; ++i) {
            for (int j = -1; j <= 9; ++j) {
                for (int k = -1; k <= 7; ++k) {
                    const double x = 0.5 * i, y = 0.5 * j, z = 0.5 * k;
                    Vec3 point;
                    point[(along + 1) % 3] = x;
                    point[(along + 2) % 3] = y;
                    point[along] = z;
                    const bool inside =
                        x > 0 && y > 0 && z > 0 && z < 3 && x < 4 && y < 4 && (x < 2 || y < 2);
                    EXPECT_EQ(is_inside(tree, point), inside) << point.transpose() << " along " << along;
                }
            }
        }
    }
}

TEST(InsideTest, KnowsWhatIsNearerToTheSurfaceThanNumbersTell) {
    const FacetTree tree(angle_iron(2));
    EXPECT_TRUE(is_inside(tree, {1e-300, 1e-300, 1e-300}));
    EXPECT_TRUE(is_inside(tree, {std::nextafter(2, 0), std::nextafter(2, 3), 1}));
    EXPECT_FALSE(is_inside(tree, {-1e-300, 1, 1}));
    EXPECT_FALSE(is_inside(tree, {std::nextafter(2, 3), std::nextafter(2, 3), 1}));
}

/// A surface, searched in all ways.
struct Searched {
    explicit Searched(SurfaceMesh the_mesh) : mesh(std::move(the_mesh)) {}

    [[nodiscard]] Corners corners(const Facet& f) const {
        return {mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]};
    }

    /// A corner, or a point of an edge or a facet, or one anywhere.
    [[nodiscard]] Vec3 random_place() const {
        const auto kind = *rc::gen::inRange(0, 5);
        if (kind == 4) return random_point(tree.box().grown(1));
        const Corners c = corners(*rc::gen::elementOf(mesh.facets));
        if (kind == 0) return c[0];
        const double along = random_number(0, 1), across = kind == 2 ? random_number(0, 1 - along) : 0;
        return c[0] + along * (c[1] - c[0]) + across * (c[2] - c[0]);
    }

    SurfaceMesh mesh;
    FacetTree tree{mesh};
    SurfaceQueries oracle{mesh};
};

const std::array<Searched, 5>& surfaces() {
    static const std::array<Searched, 5> all{Searched(angle_iron(0)), Searched(make_grasper().mesh),
                                             Searched(make_needle().mesh),
                                             Searched(make_organ_by_formula("gallbladder@6mm").rest),
                                             Searched(make_organ_by_formula("sphere@3mm").rest)};
    return all;
}

RC_GTEST_PROP(InsideTest, SaysWhatCgalSays, ()) {
    for (const Searched& surface : surfaces()) {
        const Vec3 point = surface.random_place();
        RC_ASSERT(is_inside(surface.tree, point) == surface.oracle.contains(point));
    }
}

RC_GTEST_PROP(ClosestSearch, FindsTheLowestOfTheNearestFacets, ()) {
    for (const Searched& surface : surfaces()) {
        const Vec3 point = surface.random_place();
        std::vector<double> distances;
        for (const Facet& facet : surface.mesh.facets) {
            distances.push_back((closest_on_triangle(point, surface.corners(facet)) - point).norm());
        }
        const double reach = *std::ranges::min_element(distances) + rounding;
        const auto lowest = std::ranges::find_if(distances, [&](double d) { return d <= reach; });
        const ClosestFacet found = closest_facet(surface.tree, point, rounding);
        RC_ASSERT(found.facet == lowest - distances.begin());
        RC_ASSERT((found.position - point).norm() == *lowest);
        RC_ASSERT(found.facet == surface.oracle.closest(point, rounding).facet);
        RC_ASSERT(found.position == surface.oracle.closest(point, rounding).position);
    }
}

/// The exit by the stretches of all facets, in their order along the line.
double exit_by_all_facets(const Searched& surface, const Vec3& point, const Vec3& direction,
                          double clearance) {
    std::vector<Interval> near;
    for (const Facet& facet : surface.mesh.facets) {
        const Interval stretch = stretch_near(point, direction, surface.corners(facet), clearance);
        if (!stretch.empty() && stretch.end > 0) near.push_back(stretch);
    }
    std::ranges::sort(near, {}, &Interval::begin);
    double reached = 0;
    for (auto next = near.begin(); next != near.end(); reached = next++->end) {
        for (; next != near.end() && next->begin < reached; ++next) reached = std::max(reached, next->end);
        if (next == near.end() || !surface.oracle.contains(point + reached * direction)) break;
    }
    return reached;
}

RC_GTEST_PROP(ExitSearch, FindsTheExitOfAllFacets, ()) {
    for (const Searched& surface : surfaces()) {
        Vec3 point = surface.random_place(), direction = random_direction();
        const int kind = *rc::gen::inRange(0, 4);
        if (kind == 0) direction = Vec3::Unit(*rc::gen::inRange(0, 3));
        if (kind == 1) {  // along the surface
            const Corners c = surface.corners(*rc::gen::elementOf(surface.mesh.facets));
            point = (c[0] + c[1] + c[2]) / 3;
            direction = (c[1] - c[0]).normalized();
        }
        for (const double clearance : {1e-6, 0.01, 0.5}) {
            RC_ASSERT(exit_distance(surface.tree, point, direction, clearance, rounding) ==
                      exit_by_all_facets(surface, point, direction, clearance));
        }
    }
}

TEST(FacetTree, EndsThoughItsFacetsCannotBeToldApart) {
    // A thousand copies of one facet, and ever longer facets from one corner.
    SurfaceMesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .facets = {}};
    mesh.facets.assign(1000, {0, 1, 2});
    for (int k = 1; k < 1000; ++k) {
        const auto last = static_cast<Index>(mesh.positions.size());
        mesh.positions.emplace_back(std::pow(2, k), 0, 0);
        mesh.positions.emplace_back(0, std::pow(2, k), 0);
        mesh.facets.push_back({0, last, last + 1});
    }
    const ClosestFacet found = closest_facet(FacetTree(mesh), {-1, 0, 0}, rounding);
    EXPECT_EQ(found.facet, 0);
    EXPECT_EQ(found.position, Vec3::Zero());
    EXPECT_THROW(FacetTree(SurfaceMesh{}), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
