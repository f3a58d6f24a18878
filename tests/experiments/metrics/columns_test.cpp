// Columns through facets, most of all where they meet edges and corners.

#include "experiments/metrics/tool_inside/columns.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace trocar {
namespace {

std::vector<ColumnHit> found_in(const std::vector<Vec3>& points, const Corners& facet) {
    std::vector<ColumnHit> hits;
    find_columns(points, facet, hits);
    return hits;
}

/// Every point with whole coordinates from 0 to `last`, ascending by x.
std::vector<Vec3> whole_points(int last) {
    std::vector<Vec3> points;
    for (int x = 0; x <= last; ++x) {
        for (int y = 0; y <= last; ++y) points.emplace_back(x, y, 0);
    }
    return points;
}

RC_GTEST_PROP(Columns, GoThroughOneFacetOfAFlatSurfaceWhereverItsEdgesAre, ()) {
    // A fan of eight facets around any point with whole coordinates: columns meet edges and corners.
    constexpr int last = 8;
    const int x = *rc::gen::inRange(1, last), y = *rc::gen::inRange(1, last);
    const std::vector<Vec3> around = {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {8, 4, 0},
                                      {8, 8, 0}, {4, 8, 0}, {0, 8, 0}, {0, 4, 0}};
    const std::vector<Vec3> points = whole_points(last);
    const bool from_above = *rc::gen::arbitrary<bool>();
    std::vector<int> counts(points.size(), 0);
    for (std::size_t k = 0; k < around.size(); ++k) {
        Corners facet{Vec3(x, y, 5), around[k], around[(k + 1) % around.size()]};
        if (!from_above) std::swap(facet[1], facet[2]);
        for (const auto& [column, sign] : found_in(points, facet)) {
            RC_ASSERT(sign == (from_above ? 1 : -1));
            ++counts[column];
        }
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        // A column on the border counts as moved towards +x, then +y: it is over the surface at the low ends.
        const bool over = points[k].x() < last && points[k].y() < last;
        RC_ASSERT(counts[k] == static_cast<int>(over));
    }
}

RC_GTEST_PROP(Columns, GoInAndOutOfAnyTetrahedron, ()) {
    const auto corner = [] {
        const auto whole = rc::gen::inRange(0, 5);
        return Vec3(*whole, *whole, *whole);
    };
    const Vec3 a = corner(), b = corner(), c = corner(), d = corner();
    const std::vector<Vec3> points = whole_points(4);
    std::map<Index, std::vector<int>> signs;
    for (const Corners& facet : {Corners{a, c, b}, Corners{a, b, d}, Corners{b, c, d}, Corners{c, a, d}}) {
        for (const auto& [column, sign] : found_in(points, facet)) signs[column].push_back(sign);
    }
    for (const auto& [column, met] : signs) {
        RC_ASSERT(met.size() == 2U);
        RC_ASSERT(met[0] + met[1] == 0);
    }
}

TEST(Columns, DoNotGoThroughUprightFacetsOrFacetsWithoutArea) {
    const std::vector<Vec3> points = whole_points(4);
    EXPECT_TRUE(found_in(points, {Vec3(0, 0, 0), Vec3(4, 4, 0), Vec3(2, 2, 9)}).empty());
    EXPECT_TRUE(found_in(points, {Vec3(0, 1, 0), Vec3(4, 1, 0), Vec3(4, 1, 9)}).empty());
    EXPECT_TRUE(found_in(points, {Vec3(1, 0, 0), Vec3(1, 4, 0), Vec3(1, 4, 9)}).empty());
    EXPECT_TRUE(found_in(points, {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(3, 2, 9)}).empty());
    EXPECT_TRUE(found_in(points, {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 9)}).empty());
}

TEST(Columns, AreNumberedAsTheirPointsAre) {
    const std::vector<Vec3> points = {{0, 0, 0}, {0.9, 1, 7}, {2, 0.5, 0}, {3, 1, 0}, {9, 0, 0}};
    const auto hits = found_in(points, {Vec3(0.5, 0, 0), Vec3(4, 0, 0), Vec3(2, 3, 0)});
    std::vector<Index> columns;
    for (const ColumnHit& hit : hits) columns.push_back(hit.column);
    EXPECT_EQ(columns, (std::vector<Index>{2, 3}));
}

TEST(Crossings, AreOrderedFromTheHighestDown) {
    const std::vector<Vec3> points = {{0.5, 0.5, 0}, {1, 1, 0}, {7, 7, 0}};
    const auto level = [](double z) { return Corners{Vec3(0, 0, z), Vec3(4, 0, z), Vec3(0, 4, z)}; };
    Corners tilted = level(1);  // z = 1 + x/4
    tilted[1].z() = 2;
    std::swap(tilted[1], tilted[2]);
    const Crossings crossings(points, std::vector{level(-3), tilted, level(5)});
    for (const std::size_t column : {0U, 1U}) {
        const auto met = crossings.of(column);
        ASSERT_EQ(met.size(), 3U);
        EXPECT_EQ(met[0].z, 5);
        EXPECT_DOUBLE_EQ(met[1].z, 1 + points[column].x() / 4);
        EXPECT_EQ(met[2].z, -3);
        EXPECT_EQ(met[0].sign, 1);
        EXPECT_EQ(met[1].sign, -1);
    }
    EXPECT_TRUE(crossings.of(2).empty());
}

}  // namespace
}  // namespace trocar
