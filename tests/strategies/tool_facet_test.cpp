#include <numbers>

#include <gtest/gtest.h>

#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::answer_of;

/// Near the side x + y = 4 of the square tool, whose normal is (1, 1, 0) / √2; 1 / √2 mm below it.
const Vec3 vertex(1.5, 1.5, 40);
const Vec3 normal = Vec3(1, 1, 0) / std::numbers::sqrt2;

Vec3 moved(const Vec3& motion) {
    const auto scene = contract::single_vertex(vertex, contract::flat_base(vertex), motion);
    const Response response = answer_of("tool-facet", scene);
    EXPECT_EQ(response.fallbacks, 0);
    return response.displacements.at(0).displacement;
}

/// Unit vector at that angle from the facet's normal, towards +z.
Vec3 at_angle(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return std::cos(angle) * normal + std::sin(angle) * Vec3(0, 0, 1);
}

TEST(ToolFacet, GoesWithTheMotionWhereTheFacetLeads) {
    const double depth = 1 / std::numbers::sqrt2 + 0.01;
    EXPECT_TRUE(moved(normal).isApprox(depth * normal, 1e-12));
    EXPECT_TRUE(
        moved(at_angle(44)).isApprox(depth / std::cos(44 * std::numbers::pi / 180) * at_angle(44), 1e-12));
}

TEST(ToolFacet, GoesAgainstTheMotionWhereTheFacetTrails) {
    EXPECT_TRUE(moved(-at_angle(44)).normalized().isApprox(at_angle(44), 1e-12));
}

TEST(ToolFacet, GoesAlongTheFacetsNormalWhereItSlides) {
    const double depth = 1 / std::numbers::sqrt2 + 0.01;
    for (const double angle : {46.0, 90.0, 134.0}) {
        EXPECT_TRUE(moved(at_angle(angle)).isApprox(depth * normal, 1e-12)) << angle;
    }
}

TEST(ToolFacet, DecidesDifferentlyForAlmostTheSameMotion) {
    // Section III's ambiguous situations (claim C11): two degrees turn the answer by more than 40°.
    const double cosine = moved(at_angle(44)).normalized().dot(moved(at_angle(46)).normalized());
    EXPECT_LT(cosine, std::cos(40 * std::numbers::pi / 180));
}

TEST(ToolFacet, WithoutMotionFallsBack) {
    const auto scene = contract::single_vertex(vertex, contract::flat_base(vertex), {0, 0, 0});
    const Response response = answer_of("tool-facet", scene);
    EXPECT_EQ(response.fallbacks, 1);
    EXPECT_EQ(response.displacements.at(0).displacement,
              answer_of("nearest-face", scene).displacements.at(0).displacement);
    const Response stays = answer_of("tool-facet", scene, {{"fallback", std::string("stay")}});
    EXPECT_EQ(stays.fallbacks, 1);
    EXPECT_TRUE(stays.displacements.empty());
}

}  // namespace
}  // namespace trocar
