#include "common/detection/detector.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/geometry/patches.h"
#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Pose upright(const Vec3& tip) { return {.rotation = Mat3::Identity(), .position = tip}; }

Detected detect(const Organ& organ, const Tool& tool, const Pose& before, const Pose& after) {
    Detected found;
    Detector(organ).detect(organ.rest.positions, tool, ToolMotion(before, after), found);
    return found;
}

TEST(Patches, HoldEveryFacetAndEveryVertexOnce) {
    const Organ organ = make_organ_by_formula("sphere@3mm");
    std::vector<int> facets(organ.rest.facets.size(), 0), vertices(organ.rest.positions.size(), 0);
    for (const Patch& patch : split_into_patches(organ.rest, 100)) {
        EXPECT_LE(patch.facets.size(), 100U);
        for (const Index facet : patch.facets) ++facets[facet];
        for (const Index vertex : patch.vertices) ++vertices[vertex];
    }
    EXPECT_THAT(facets, testing::Each(1));
    EXPECT_THAT(vertices, testing::Each(1));
}

TEST(Detector, FindsNothingBesideTheOrgan) {
    const Organ organ = make_organ_by_formula("sphere@6mm");
    const Detected found = detect(organ, make_prism(12), upright({0, 0, 50}), upright({0, 0, 45}));
    EXPECT_THAT(found.collided, IsEmpty());
    EXPECT_THAT(found.crossed, IsEmpty());
}

TEST(Detector, FindsVerticesDeepInsideTheTool) {
    // The organ is far smaller than the tool and crosses its surface nowhere.
    SurfaceMesh mesh = make_organ_by_formula("sphere@20mm").rest;
    for (Vec3& position : mesh.positions) position *= 0.02;
    const Organ organ = make_organ("bead", mesh);
    const Detected found = detect(organ, make_prism(12), upright({0, 0, -40}), upright({0, 0, -40}));
    std::vector<Index> all(organ.rest.positions.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(found.collided, all);
    EXPECT_EQ(found.crossed.size(), organ.rest.facets.size()) << "every facet has a vertex inside";
}

TEST(Detector, FindsAFacetThatTheToolPiercesBetweenItsVertices) {
    // Two large facets; the tool goes through the middle of the first.
    const Organ organ =
        make_organ("square", {{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    const Detected found = detect(organ, make_prism(6), upright({70, 20, 3}), upright({70, 20, -5}));
    EXPECT_THAT(found.collided, IsEmpty());
    EXPECT_THAT(found.crossed, ElementsAre(0));
}

TEST(Detector, TouchingIsNotCrossing) {
    const Organ organ =
        make_organ("square", {{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    const Detected found = detect(organ, make_prism(6), upright({70, 20, 3}), upright({70, 20, 0}));
    EXPECT_THAT(found.crossed, IsEmpty());
    EXPECT_THAT(found.near_facets, ElementsAre(0, 1)) << "its box does touch both";
}

TEST(Detector, WhatLiesBetweenOpenJawsIsNeitherInsideNorCrossed) {
    // Above the plane of the tips by 6 mm, the jaws are at 4 mm and more from the axis.
    const Organ organ = make_organ(
        "strip", {{{-1, -6.5, 6}, {1, -6.5, 6}, {-1, -2, 6}, {1, -2, 6}, {-1, 2, 6}, {1, 2, 6}, {0, 4.8, 6}},
                  {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 6}}});
    const Detected found = detect(organ, make_grasper(), upright({0, 0, 0}), upright({0, 0, 0}));
    EXPECT_THAT(found.collided, ElementsAre(6)) << "in the jaw at +y";
    EXPECT_THAT(found.crossed, ElementsAre(0, 1, 4)) << "the jaw at -y lies between 0, 1 and 2, 3";
    EXPECT_THAT(found.near_facets, ElementsAre(0, 1, 2, 3, 4));
}

TEST(Detector, KnowsWhatTheToolSweptOver) {
    const Organ organ = make_organ_by_formula("sheet@5mm");
    // From above the sheet to below it in one step: nothing is inside the tool at the end, but it passed
    // through.
    const Tool tool = make_prism(8, 4, 10);
    const Detected found = detect(organ, tool, upright({0, 0, 5}), upright({0, 0, -30}));
    EXPECT_THAT(found.collided, IsEmpty());
    EXPECT_THAT(found.near_vertices, testing::Not(IsEmpty()));
    for (const Index vertex : found.near_vertices) {
        EXPECT_LE(organ.rest.positions[vertex].head<2>().cwiseAbs().maxCoeff(), tool.radius);
    }
}

TEST(Detector, FollowsTheOrganAsItMoves) {
    const Organ organ = make_organ_by_formula("sphere@6mm");
    const Tool tool = make_prism(12);
    Detector detector(organ);
    const ToolMotion still(upright({0, 0, 60}), upright({0, 0, 60}));
    Detected found;
    std::vector<Vec3> positions = organ.rest.positions;
    detector.detect(positions, tool, still, found);
    EXPECT_THAT(found.collided, IsEmpty());
    for (Vec3& position : positions) position.z() += 30;
    detector.follow_all(positions);
    detector.detect(positions, tool, still, found);
    EXPECT_THAT(found.collided, testing::Not(IsEmpty()));
}

}  // namespace
}  // namespace trocar
