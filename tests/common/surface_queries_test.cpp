#include "common/geometry/surface_queries.h"

#include <thread>

#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

// A box from the origin to (4, 6, 8).
const SurfaceMesh box = {
    .positions = {{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {0, 0, 8}, {4, 0, 8}, {4, 6, 8}, {0, 6, 8}},
    .facets = {{0, 2, 1},
               {0, 3, 2},
               {4, 5, 6},
               {4, 6, 7},
               {0, 1, 5},
               {0, 5, 4},
               {1, 2, 6},
               {1, 6, 5},
               {2, 3, 7},
               {2, 7, 6},
               {3, 0, 4},
               {3, 4, 7}}};

TEST(SurfaceQueries, ContainsIsStrict) {
    const SurfaceQueries queries(box);
    EXPECT_TRUE(queries.contains({2, 3, 4}));
    EXPECT_TRUE(queries.contains({1e-12, 1e-12, 1e-12}));
    EXPECT_FALSE(queries.contains({-1e-12, 3, 4}));
    EXPECT_FALSE(queries.contains({0, 3, 4})) << "on a face";
    EXPECT_FALSE(queries.contains({4, 6, 8})) << "at a corner";
    EXPECT_FALSE(queries.contains({2, 3, 100}));
}

TEST(SurfaceQueries, DistanceIsToTheSurface) {
    const SurfaceQueries queries(box);
    EXPECT_DOUBLE_EQ(queries.distance({1, 3, 4}), 1);
    EXPECT_DOUBLE_EQ(queries.distance({-3, 3, 12}), 5);
    EXPECT_EQ(queries.distance({4, 2, 2}), 0);
}

TEST(SurfaceQueries, RayLeavesWhereTheNormalPointsAlongIt) {
    const SurfaceQueries queries(box);
    EXPECT_DOUBLE_EQ(queries.distance_to_exit({1, 2, 3}, {1, 0, 0}, 0).value(), 3);
    EXPECT_DOUBLE_EQ(queries.distance_to_exit({-5, 2, 3}, {1, 0, 0}, 0).value(), 9) << "not where it enters";
    EXPECT_DOUBLE_EQ(queries.distance_to_exit({2, 3, 0}, {0, 0, 1}, 1e-9).value(), 8) << "from the surface";
    EXPECT_FALSE(queries.distance_to_exit({1, 2, 3}, {1, 0, 0}, 3.5).has_value()) << "further than skip";
    EXPECT_FALSE(queries.distance_to_exit({-1, 2, 3}, {-1, 0, 0}, 0).has_value());
}

TEST(SurfaceQueries, GiveTheSameAnswersFromSeveralThreads) {
    const Organ sphere = make_organ_by_formula("sphere@10mm");
    const SurfaceQueries queries(sphere.rest);
    const auto ask = [&](std::vector<double>& answers) {
        for (int i = 0; i < 500; ++i) {
            const Vec3 point(0.1 * i, 0.05 * i, 1);
            answers.push_back(queries.distance(point) + (queries.contains(point) ? 1000 : 0));
        }
    };
    std::vector<double> expected, first, second;
    {
        const std::jthread one([&] { ask(first); });
        const std::jthread other([&] { ask(second); });
    }
    ask(expected);
    EXPECT_EQ(first, expected);
    EXPECT_EQ(second, expected);
}

}  // namespace
}  // namespace trocar
