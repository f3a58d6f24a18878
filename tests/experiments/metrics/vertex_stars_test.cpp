#include "experiments/metrics/self_crossing/vertex_stars.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "cgal_oracle.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::cgal_self_intersections;
using testing_support::random_direction;
using testing_support::random_number;

constexpr double degree = std::numbers::pi / 180;

/// A star around vertex 0 whose other vertices are at these angles (degrees) around it, 1 mm away.
SurfaceMesh star(const std::vector<double>& angles, bool closed) {
    SurfaceMesh mesh{.positions = {Vec3::Zero()}, .facets = {}};
    for (const double angle : angles) {
        mesh.positions.emplace_back(std::cos(angle * degree), std::sin(angle * degree), 0);
    }
    const auto count = static_cast<Index>(angles.size());
    for (Index k = 1; k < count; ++k) mesh.facets.push_back({0, k, k + 1});
    if (closed) mesh.facets.push_back({0, count, 1});
    return mesh;
}

bool unfolds(const SurfaceMesh& mesh) {
    const Organ organ = make_organ("star", mesh);
    return VertexStars(organ).unfolding(0, mesh.positions).has_value();
}

double freedom(const SurfaceMesh& mesh) {
    const Organ organ = make_organ("star", mesh);
    return VertexStars(organ).freedom(0, mesh.positions);
}

const std::vector<double> around = {0, 60, 120, 180, 240, 300};

TEST(VertexStars, UnfoldAlongTheirMeanNormal) {
    SurfaceMesh hexagon = star(around, true);
    EXPECT_TRUE(unfolds(hexagon));
    hexagon.positions[0].z() = 5;
    EXPECT_TRUE(unfolds(hexagon)) << "a steep tent";
    hexagon.positions[0] = {0.5, 0, 0};
    EXPECT_TRUE(unfolds(hexagon));
    hexagon.positions[0] = {1.2, 0, 0};
    EXPECT_FALSE(unfolds(hexagon)) << "beyond the others";
    hexagon.positions[0] = {0, 0, 0};
    hexagon.positions[2] = hexagon.positions[4] + Vec3(0, 0.01, 0.1);
    EXPECT_FALSE(unfolds(hexagon)) << "folded over";
    hexagon.positions[2] = hexagon.positions[0];
    EXPECT_FALSE(unfolds(hexagon)) << "a facet without area";
}

TEST(VertexStars, GoRoundOnce) {
    EXPECT_FALSE(unfolds(star({0, 100, 200, 300, 400, 500, 600}, true))) << "twice";
    EXPECT_FALSE(unfolds(star({0, 120, 240, 360, 480, 600}, true))) << "twice, over each other";
    EXPECT_TRUE(unfolds(star({0, 90, 180}, false))) << "half, as at the side of a sheet";
    EXPECT_TRUE(unfolds(star({0, 90}, false))) << "a quarter, as at its corner";
    EXPECT_TRUE(unfolds(star({0, 90, 180, 270, 359}, false))) << "nearly closed";
    EXPECT_TRUE(unfolds(star({0, 100, 200}, false)));
    EXPECT_FALSE(unfolds(star({0, 90, 180, 270, 360}, false))) << "its sides meet";
    EXPECT_FALSE(unfolds(star({0, 90, 180, 270, 361}, false))) << "its ends lie over each other";
    EXPECT_FALSE(unfolds(star({0, 90, 180, 270, 360, 450, 540, 600}, false)));
}

TEST(VertexStars, AreFreeToMoveByHalfTheirLeastHeight) {
    EXPECT_NEAR(freedom(star(around, true)), std::sqrt(3) / 4, 1e-12);
    EXPECT_NEAR(freedom(star({0, 90, 180, 270}, true)), std::sqrt(0.5) / 2, 1e-12);
    EXPECT_NEAR(freedom(star({0, 90, 180}, false)), std::sqrt(0.5) / 2, 1e-12);
    const double across = 2 * std::sin(5 * degree);
    EXPECT_NEAR(freedom(star({0, 90, 180, 270, 350}, false)), across * std::cos(5 * degree) / 2, 1e-12)
        << "until the gap closes";
    EXPECT_EQ(freedom(star({0, 90, 180, 270, 361}, false)), 0) << "not unfolded";
}

TEST(VertexStars, DoNotMeetThemselvesWhereTheyUnfoldNorWithinTheirFreedom) {
    int unfolded = 0;
    EXPECT_TRUE(rc::check([&] {
        const bool closed = *rc::gen::arbitrary<bool>();
        const int count = static_cast<int>(random_number(3, 8.99));
        std::vector<double> angles;
        const double turn = (closed ? 360 : random_number(20, 355)) / (closed ? count : count - 1);
        for (int k = 0; k < count; ++k) angles.push_back(turn * k);
        SurfaceMesh mesh = star(angles, closed);
        const double size = random_number(0, 1);
        for (Vec3& p : mesh.positions) p += random_number(0, size) * random_direction();
        RC_PRE(unfolds(mesh));
        ++unfolded;
        RC_ASSERT(cgal_self_intersections(mesh).empty());
        const double limit = freedom(mesh);
        RC_ASSERT(limit > 0);
        for (Vec3& p : mesh.positions) p += 0.999999 * limit * random_direction();
        RC_ASSERT(cgal_self_intersections(mesh).empty());
    }));
    EXPECT_GT(unfolded, 50);
}

}  // namespace
}  // namespace trocar
