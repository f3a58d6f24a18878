#include "common/geometry/organ_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trocar {
namespace {

// Every edge's length, ascending.
std::vector<double> edge_lengths(const Organ& organ) {
    std::vector<double> lengths;
    for (const auto& [a, b] : organ.adjacency.edges()) {
        lengths.push_back((organ.rest.positions[a] - organ.rest.positions[b]).norm());
    }
    std::ranges::sort(lengths);
    return lengths;
}

std::string message_of(const std::string& formula) {
    try {
        make_organ_by_formula(formula);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing was thrown";
}

class Sphere : public testing::TestWithParam<const char*> {};

TEST_P(Sphere, IsClosedRoundAndOutward) {
    const Organ organ = make_organ_by_formula(GetParam());
    EXPECT_EQ(organ.name, GetParam());
    EXPECT_TRUE(organ.adjacency.closed());
    EXPECT_EQ(organ.rest.positions.size() + organ.rest.facets.size(), organ.adjacency.edges().size() + 2);
    for (const Vec3& position : organ.rest.positions) EXPECT_NEAR(position.norm(), 40, 1e-12);
    for (std::size_t f = 0; f < organ.rest.facets.size(); ++f) {
        EXPECT_GT(organ.rest_normals[f].dot(organ.rest.positions[organ.rest.facets[f][0]]), 0);
    }
    const std::vector<double> lengths = edge_lengths(organ);
    EXPECT_LT(lengths.back() / lengths.front(), 1.5);
}
INSTANTIATE_TEST_SUITE_P(Edges, Sphere,
                         testing::Values("sphere@60mm", "sphere@10mm", "sphere@4mm", "sphere@2.5mm"));

TEST(Sphere, HasTheAskedEdgesAndVolume) {
    const Organ organ = make_organ_by_formula("sphere@2mm");
    const std::vector<double> lengths = edge_lengths(organ);
    EXPECT_NEAR(lengths[lengths.size() / 2], 2, 0.1);
    EXPECT_NEAR(signed_volume(organ.rest), 4 * std::numbers::pi / 3 * 40 * 40 * 40, 500);
}

TEST(Sheet, IsAFlatSquareWithStraightBorders) {
    const Organ organ = make_organ_by_formula("sheet@4mm");
    EXPECT_FALSE(organ.adjacency.closed());
    EXPECT_EQ(organ.rest.positions.size() + organ.rest.facets.size(), organ.adjacency.edges().size() + 1);
    double area = 0;
    for (std::size_t f = 0; f < organ.rest.facets.size(); ++f) {
        area += organ.rest_areas[f];
        EXPECT_EQ(organ.rest_normals[f], Vec3::UnitZ());
    }
    EXPECT_NEAR(area, 120 * 120, 1e-8);
    for (std::size_t v = 0; v < organ.rest.positions.size(); ++v) {
        const Vec3& position = organ.rest.positions[v];
        EXPECT_EQ(position.z(), 0);
        const bool at_side = std::max(std::abs(position.x()), std::abs(position.y())) == 60;
        EXPECT_EQ(organ.adjacency.on_boundary(static_cast<Index>(v)), at_side);
    }
}

TEST(Sheet, HasAnOutline) {
    const Organ organ = make_organ_by_formula("sheet@20mm");
    ASSERT_TRUE(organ.outline.has_value());
    EXPECT_EQ(organ.outline->half_x, 60);
    EXPECT_EQ(organ.outline->half_y, 60);
    EXPECT_FALSE(make_organ_by_formula("sphere@20mm").outline.has_value());
}

TEST(Sheet, IsOfNearlyEquilateralFacets) {
    const Organ organ = make_organ_by_formula("sheet@4mm");
    const std::vector<double> lengths = edge_lengths(organ);
    const auto odd = std::ranges::count_if(lengths, [](double length) { return std::abs(length - 4) > 0.1; });
    EXPECT_LT(static_cast<double>(odd), 0.04 * static_cast<double>(lengths.size())) << "only at two borders";
}

TEST(OrganByFormula, HasEdgesOfFourMillimetresByDefault) {
    for (const OrganShape& shape : all_organ_shapes()) {
        const Organ organ = make_organ_by_formula(shape.name);
        EXPECT_EQ(organ.name, shape.name + "@4mm");
        EXPECT_EQ(organ.rest.facets, make_organ_by_formula(shape.name + "@4.0mm").rest.facets);
    }
}

TEST(OrganByFormula, SaysWhatWasExpected) {
    using testing::HasSubstr;
    EXPECT_THAT(message_of("shpere@4mm"), HasSubstr("unknown organ \"shpere\"; did you mean \"sphere\"?"));
    for (const OrganShape& shape : all_organ_shapes()) {
        EXPECT_THAT(message_of("shpere@4mm"), HasSubstr(shape.name));
    }
    for (const std::string wrong :
         {"sphere@", "sphere@4", "sphere@mm", "sphere@4cm", "sphere@4 mm", "sphere@4mm "}) {
        EXPECT_THAT(message_of(wrong), HasSubstr("such as sphere@4mm")) << wrong;
    }
    for (const std::string edge : {"0", "-1", "nan", "inf", "81", "0.1", "1e-300"}) {
        EXPECT_THAT(message_of("sphere@" + edge + "mm"), HasSubstr("expected one from 0.12 mm to 80 mm"));
    }
}

TEST(OrganByFormula, TakesTheEndsOfItsRangeAndNothingBeyond) {
    for (const OrganShape& shape : all_organ_shapes()) {
        const auto formula = [&](double edge) { return fmt::format("{}@{}mm", shape.name, edge); };
        EXPECT_EQ(make_organ_by_formula(formula(shape.longest_edge)).name, formula(shape.longest_edge));
        for (const double edge : {1.01 * shape.longest_edge, 0.99 * shape.shortest_edge}) {
            EXPECT_THAT(message_of(formula(edge)),
                        testing::HasSubstr(fmt::format("from {} mm to {} mm for a {}", shape.shortest_edge,
                                                       shape.longest_edge, shape.name)));
        }
    }
}

}  // namespace
}  // namespace trocar
