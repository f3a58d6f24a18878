#include "common/geometry/adjacency.h"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<Facet> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(Adjacency, OfATetrahedron) {
    const Adjacency around(4, tetrahedron);
    EXPECT_TRUE(around.closed());
    EXPECT_THAT(around.ring(0), ElementsAre(0, 1, 3));
    EXPECT_THAT(around.ring(3), ElementsAre(1, 2, 3));
    EXPECT_THAT(around.neighbours(2), ElementsAre(0, 1, 3));
    EXPECT_THAT(around.edges(),
                ElementsAre(Edge{0, 1}, Edge{0, 2}, Edge{0, 3}, Edge{1, 2}, Edge{1, 3}, Edge{2, 3}));
    EXPECT_FALSE(around.on_boundary(0));
}

TEST(Adjacency, OpenFanIsTurnedToItsLowestFacet) {
    // Three facets around vertex 0, counter-clockwise 2, 0, 1 from the border.
    const std::vector<Facet> fan = {{0, 2, 3}, {3, 4, 0}, {1, 2, 0}};
    const Adjacency around(5, fan);
    EXPECT_THAT(around.ring(0), ElementsAre(0, 1, 2));
    EXPECT_THAT(around.neighbours(0), ElementsAre(1, 2, 3, 4));
    EXPECT_TRUE(around.on_boundary(0));
    EXPECT_FALSE(around.closed());
}

TEST(Adjacency, ARingCanBeginAtAnyOfItsFacets) {
    Adjacency around(4, tetrahedron);
    around.begin_ring_at(3, 2);
    EXPECT_THAT(around.ring(3), ElementsAre(2, 3, 1));
    around.begin_ring_at(3, 3);
    EXPECT_THAT(around.ring(3), ElementsAre(3, 1, 2));
    EXPECT_THAT(around.ring(0), ElementsAre(0, 1, 3)) << "others are as they were";
    EXPECT_THAT(around.ring(2), ElementsAre(0, 3, 2));
    around.begin_ring_at(3, 1);
    EXPECT_THAT(around.ring(3), ElementsAre(1, 2, 3));
    EXPECT_THROW(around.begin_ring_at(3, 0), std::invalid_argument) << "it is on the other side";

    Adjacency open(5, std::vector<Facet>{{0, 2, 3}, {3, 4, 0}, {1, 2, 0}});
    open.begin_ring_at(0, 2);
    EXPECT_THAT(open.ring(0), ElementsAre(2, 0, 1));
}

TEST(Adjacency, VertexWithoutFacets) {
    const Adjacency around(5, tetrahedron);
    EXPECT_THAT(around.ring(4), IsEmpty());
    EXPECT_THAT(around.neighbours(4), IsEmpty());
    EXPECT_TRUE(around.closed());
}

TEST(Adjacency, RefusesWhatIsNotOneFan) {
    const std::vector<Facet> bow_tie = {{0, 1, 2}, {0, 3, 4}};
    EXPECT_THROW(Adjacency(5, bow_tie), std::invalid_argument);
    const std::vector<Facet> three_on_an_edge = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    EXPECT_THROW(Adjacency(5, three_on_an_edge), std::invalid_argument);
    const std::vector<Facet> against_each_other = {{0, 1, 2}, {0, 1, 3}};
    EXPECT_THROW(Adjacency(4, against_each_other), std::invalid_argument);
    std::vector<Facet> touching = tetrahedron;  // two closed fans around vertex 0
    for (const auto& [a, b, c] : tetrahedron) {
        const auto other = [](Index v) { return v == 0 ? 0 : v + 3; };
        touching.push_back({other(a), other(b), other(c)});
    }
    EXPECT_THROW(Adjacency(7, touching), std::invalid_argument);
}

TEST(Adjacency, RefusesWrongVertexNumbers) {
    EXPECT_THROW(Adjacency(3, tetrahedron), std::invalid_argument);
    const std::vector<Facet> negative = {{0, 1, -1}};
    EXPECT_THROW(Adjacency(3, negative), std::invalid_argument);
    const std::vector<Facet> twice = {{0, 1, 1}};
    EXPECT_THROW(Adjacency(3, twice), std::invalid_argument);
}

// The vertex before or after `vertex` in a facet.
Index beside(const Facet& facet, Index vertex, std::size_t steps) {
    const auto at = static_cast<std::size_t>(std::ranges::find(facet, vertex) - facet.begin());
    return facet[(at + steps) % 3];
}

void expect_rings_as_described(const SurfaceMesh& mesh, const Adjacency& around) {
    for (Index v = 0; static_cast<std::size_t>(v) < mesh.positions.size(); ++v) {
        const std::span<const Index> ring = around.ring(v);
        ASSERT_FALSE(ring.empty());
        EXPECT_EQ(ring[0], std::ranges::min(ring));
        std::size_t gaps = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Facet& facet = mesh.facets[ring[i]];
            const Facet& next = mesh.facets[ring[(i + 1) % ring.size()]];
            if (beside(facet, v, 2) != beside(next, v, 1)) ++gaps;
        }
        EXPECT_EQ(gaps, around.on_boundary(v) ? 1U : 0U) << "around vertex " << v;
    }
}

RC_GTEST_PROP(Adjacency, DoesNotDependOnHowFacetsAreNumbered, ()) {
    const bool closed = *rc::gen::arbitrary<bool>();
    SurfaceMesh mesh = make_organ_by_formula(closed ? "sphere@30mm" : "sheet@40mm").rest;
    std::shuffle(mesh.facets.begin(), mesh.facets.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
    for (Facet& facet : mesh.facets) {
        std::rotate(facet.begin(), facet.begin() + *rc::gen::inRange(0, 3), facet.end());
    }
    const Adjacency around(mesh.positions.size(), mesh.facets);
    RC_ASSERT(around.closed() == closed);
    expect_rings_as_described(mesh, around);
    std::set<Edge> edges;
    for (const auto& [a, b, c] : mesh.facets) {
        edges.insert({std::min(a, b), std::max(a, b)});
        edges.insert({std::min(b, c), std::max(b, c)});
        edges.insert({std::min(c, a), std::max(c, a)});
    }
    RC_ASSERT(std::ranges::equal(edges, around.edges()));
}

}  // namespace
}  // namespace trocar
