#include "experiments/scenes/placement.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/scenes/draws.h"
#include "stage.h"

namespace trocar {
namespace {

TEST(Draws, AreTheSameForTheSameArgumentsAndDifferOtherwise) {
    EXPECT_EQ(draw(3, 7), draw(3, 7));
    EXPECT_NE(draw(3, 7), draw(3, 8));
    EXPECT_NE(draw(3, 7), draw(4, 7));
}

TEST(Draws, AreUniform) {
    double sum = 0, squares = 0;
    constexpr int count = 100'000;
    for (int k = 0; k < count / 4; ++k) {
        for (const double u : draw(11, k)) {
            ASSERT_TRUE(u >= 0 && u < 1);
            sum += u;
            squares += u * u;
        }
    }
    EXPECT_NEAR(sum / count, 1.0 / 2, 0.005);
    EXPECT_NEAR(squares / count, 1.0 / 3, 0.005);
}

TEST(Placement, IsOnTheSurfaceWithItsNormal) {
    const Stage stage("sphere@4mm");
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Placement placement = place(stage.inputs(100, seed), {.depth = 12});
        EXPECT_LT(stage.queries.distance(placement.entry), 1e-9);
        EXPECT_GT(placement.normal.dot(placement.entry.normalized()), 0.99);
        EXPECT_NEAR(placement.normal.norm(), 1, 1e-12);
        EXPECT_NEAR(placement.tangent.norm(), 1, 1e-12);
        EXPECT_NEAR(placement.tangent.dot(placement.normal), 0, 1e-12);
        EXPECT_TRUE(placement.phase >= 0 && placement.phase < 1);
    }
}

TEST(Placement, DoesNotDependOnTheSpeed) {
    const Stage stage("sphere@4mm");
    EXPECT_EQ(place(stage.inputs(20, 5), {.depth = 12}).entry,
              place(stage.inputs(400, 5), {.depth = 12}).entry);
}

TEST(Placement, IsUniformByArea) {
    // A third of a square sheet's inner part gets a third of the points, although its facets are as many
    // anywhere.
    const Stage stage("sheet@6mm");
    int left = 0;
    constexpr int count = 3000;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const Vec3 entry = place(stage.inputs(100, seed), {.depth = 12}).entry;
        ASSERT_LE(entry.head<2>().cwiseAbs().maxCoeff(), 60 - 8 + 1e-9)
            << "nearer than two radii to the boundary";
        if (entry.x() < -52.0 / 3) ++left;
    }
    EXPECT_NEAR(left, count / 3.0, 4 * std::sqrt(count * 2.0 / 9));
}

TEST(Placement, RefusesOrgansThatAreTooThinEverywhere) {
    SurfaceMesh flat = make_organ_by_formula("sphere@8mm").rest;
    for (Vec3& position : flat.positions) position *= 0.25;  // 20 mm across
    const Stage stage("sphere@8mm");
    const Organ thin = make_organ("thin", flat);
    const SurfaceQueries queries(thin.rest);
    const SceneInputs inputs{
        .organ = thin, .organ_queries = queries, .tool = stage.tool, .speed = 100, .dt = 1.0 / 30, .seed = 1};
    try {
        (void)place(inputs, {.depth = 12});
        FAIL() << "no error";
    } catch (const PlacementError& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("\"thin\""), testing::HasSubstr("24 mm")));
    }
}

TEST(Placement, ThinDrawsOnlyWhatTheOthersDoNot) {
    // A sphere squashed to 20 mm: thinner than 24 mm in its middle, thicker along the normals of its rim.
    SurfaceMesh squashed = make_organ_by_formula("sphere@4mm").rest;
    for (Vec3& position : squashed.positions) position.z() *= 0.25;
    const Stage stage("sphere@8mm");
    const Organ lens = make_organ("lens", squashed);
    const SurfaceQueries queries(lens.rest);
    SceneInputs inputs = stage.inputs(100, 1);
    const SceneInputs on_lens{.organ = lens,
                              .organ_queries = queries,
                              .tool = stage.tool,
                              .speed = inputs.speed,
                              .dt = inputs.dt,
                              .seed = 1};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SceneInputs seeded = on_lens;
        seeded.seed = seed;
        for (const bool thin : {false, true}) {
            const Placement at = place(seeded, {.depth = 12, .thin = thin});
            const auto through = queries.distance_to_exit(at.entry, -at.normal, 1e-5);
            ASSERT_TRUE(through);
            EXPECT_EQ(*through < 24, thin) << "seed " << seed;
        }
    }
}

TEST(Placement, TheWayAsideStaysClearOfTheBoundaryToo) {
    const Stage stage("sheet@6mm");
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Placement at = place(stage.inputs(100, seed), {.depth = 3, .aside = 30});
        const Vec3 end = at.entry + 30 * at.tangent;
        EXPECT_LE(end.head<2>().cwiseAbs().maxCoeff(), 60 - 8 + 1e-9);
    }
}

TEST(Placement, TheNormalIsThatOfOneWall) {
    // Two sheets 2 mm apart, back to back: the mean of both walls would be no direction at all.
    SurfaceMesh walls = make_organ_by_formula("sheet@6mm").rest;
    const auto vertices = static_cast<Index>(walls.positions.size());
    const std::size_t facets = walls.facets.size();
    for (Index v = 0; v < vertices; ++v) walls.positions.emplace_back(walls.positions[v] - Vec3(0, 0, 2));
    for (std::size_t f = 0; f < facets; ++f) {
        const auto [a, b, c] = walls.facets[f];
        walls.facets.push_back({vertices + c, vertices + b, vertices + a});
    }
    const Stage stage("sphere@8mm");
    const Organ organ = make_organ("walls", walls);
    const SurfaceQueries queries(organ.rest);
    SceneInputs inputs{.organ = organ,
                       .organ_queries = queries,
                       .tool = stage.tool,
                       .speed = 100,
                       .dt = 1.0 / 30,
                       .seed = 1};
    for (; inputs.seed <= 10; ++inputs.seed) {
        const Placement at = place(inputs, {.depth = 12, .thin = true});
        EXPECT_TRUE(at.normal.isApprox(at.entry.z() > -1 ? Vec3(0, 0, 1) : Vec3(0, 0, -1), 1e-9));
    }
}

TEST(Unsuited, SaysWhichSceneHasNoPlaceOnWhichOrgan) {
    const Stage sphere("sphere@8mm");
    EXPECT_EQ(unsuited(find_scene("penetration"), sphere.inputs(100, 1)), "");
    EXPECT_THAT(unsuited(find_scene("thin"), sphere.inputs(100, 1)), testing::HasSubstr("thinner organ"));
    EXPECT_THAT(unsuited(find_scene("cutting"), sphere.inputs(100, 1)), testing::HasSubstr("no cleft"));
}

}  // namespace
}  // namespace trocar
