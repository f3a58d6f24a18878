#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>
#include <thread>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "cgal_oracle.h"
#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/metrics/self_crossing/self_intersections.h"
#include "judged_steps.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::cgal_self_intersections;
using testing_support::random_direction;
using testing_support::random_number;

/// CGAL's pairs of the whole mesh with these vertices less those of the mesh at rest.
std::vector<FacetPair> expected_pairs(const Organ& organ, const std::vector<Vec3>& positions) {
    const std::vector<FacetPair> rest = cgal_self_intersections(organ.rest);
    const std::vector<FacetPair> now = cgal_self_intersections({positions, organ.rest.facets});
    std::vector<FacetPair> beyond;
    std::ranges::set_difference(now, rest, std::back_inserter(beyond));
    return beyond;
}

/// A strip of six facets that runs up from a large one, turns over and comes down on it with its last corner,
/// at `tip`.
Organ strip(const Vec3& tip) {
    return make_organ(
        "strip",
        {.positions = {{0, 0, 0}, {10, 0, 0}, {5, 10, 0}, {12, 9, 4}, {7, 9, 6}, {7, 4, 6}, {5, 5, 5}, tip},
         .facets = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 6}, {6, 5, 7}}});
}

TEST(SelfCrossings, ArePairsThatMeetElsewhereThanTheyJoin) {
    const Organ organ = strip({5, 3, 4});
    const SelfIntersections found(organ);
    EXPECT_TRUE(found.at_rest().empty());
    std::vector<Vec3> positions = organ.rest.positions;
    const auto with_tip_at = [&](const Vec3& tip) {
        positions[7] = tip;
        return found.beyond_rest(positions);
    };
    EXPECT_TRUE(with_tip_at({5, 3, 1e-9}).empty());
    EXPECT_EQ(with_tip_at({5, 3, -1}), (std::vector<FacetPair>{{0, 5}})) << "through";
    EXPECT_EQ(with_tip_at({5, 3, 0}), (std::vector<FacetPair>{{0, 5}})) << "touching";
    EXPECT_EQ(with_tip_at({5, 0, 0}), (std::vector<FacetPair>{{0, 5}})) << "touching a side";
    EXPECT_TRUE(with_tip_at({5, -1e-9, 0}).empty()) << "beside it";
    positions[5] = {6, 4.5, 5};
    positions[6] = {7, 4, 5};
    EXPECT_TRUE(with_tip_at({4, 5.5, 5}).empty()) << "collapsed to a line";
    EXPECT_TRUE(with_tip_at({0, 7.5, 5}).empty());
    positions[5] = positions[6] = {0, 0, -2};
    EXPECT_EQ(with_tip_at({5, 3, 4}), (std::vector<FacetPair>{{0, 3}}))
        << "facets 4 and 5, without area, count for nothing";
}

TEST(SelfCrossings, DoNotCountThePairsAtRest) {
    const Organ organ = strip({5, 3, -1});
    const SelfIntersections found(organ);
    EXPECT_EQ(found.at_rest(), (std::vector<FacetPair>{{0, 5}}));
    std::vector<Vec3> positions = organ.rest.positions;
    EXPECT_TRUE(found.beyond_rest(positions).empty());
    positions[7] = {6, 3, -2};
    EXPECT_TRUE(found.beyond_rest(positions).empty()) << "the same pair";
    positions[6] = {5, 5, -2};
    EXPECT_EQ(found.beyond_rest(positions), (std::vector<FacetPair>{{0, 4}})) << "one more";
    EXPECT_EQ(expected_pairs(organ, positions), (std::vector<FacetPair>{{0, 4}}));
}

TEST(SelfCrossings, OfFacetsThatComeHalfWayTowardsEachOther) {
    const Organ organ = make_organ("pair", {.positions = {{0, 0, 0},
                                                          {9, 0, 0},
                                                          {0, 9, 0},  //
                                                          {0, 0, 1},
                                                          {9, 0, 1},
                                                          {0, 9, 1}},
                                            .facets = {{0, 1, 2}, {3, 4, 5}}});
    const SelfIntersections found(organ);
    const auto closer_by = [&](double each) {
        std::vector<Vec3> positions = organ.rest.positions;
        for (Vec3& p : positions) p.z() += p.z() == 0 ? each : -each;
        return found.beyond_rest(positions).size();
    };
    EXPECT_EQ(closer_by(0.5), 1U);
    EXPECT_EQ(closer_by(0.5 - 1e-9), 0U);
}

TEST(SelfCrossings, OfFacetsFoldedFlat) {
    // Two facets that join in an edge meet elsewhere once one is folded flat onto the other.
    const Organ organ = make_organ("hinge", {.positions = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}},
                                             .facets = {{0, 1, 2}, {1, 0, 3}}});
    const SelfIntersections found(organ);
    std::vector<Vec3> positions = organ.rest.positions;
    positions[3] = {2, 2, 0};
    EXPECT_EQ(found.beyond_rest(positions).size(), 1U);
    positions[3].z() = 1e-9;
    EXPECT_TRUE(found.beyond_rest(positions).empty());
}

/// Steps of an organ that meets no tool.
class SelfCrossingsOf : public testing::Test {
  protected:
    static double metric(const Organ& organ, const std::vector<Vec3>& positions) {
        const JudgedSteps steps(organ, make_prism(4));
        const Judged step = steps.step(tip_at(500), organ.rest.positions, positions, organ.rest.positions);
        EXPECT_EQ(value("self_crossings", Moment::deformed, step), 0);
        return value("self_crossings", Moment::handled, step);
    }
};

TEST_F(SelfCrossingsOf, TwoTentsWhoseTopsTouch) {
    const Organ sheet = make_organ_by_formula("sheet@8mm");
    const auto nearest_to = [&](const Vec3& place) {
        const auto distance = [&](const Vec3& p) { return (p - place).norm(); };
        const auto found = std::ranges::min_element(sheet.rest.positions, {}, distance);
        return static_cast<Index>(found - sheet.rest.positions.begin());
    };
    const Index one = nearest_to({-20, 0, 0}), other = nearest_to({20, 0, 0});
    std::vector<Vec3> positions = sheet.rest.positions;
    positions[one] = positions[other] = {1, 2, 30};
    const auto facets_around = [&](Index vertex) {
        return static_cast<double>(sheet.adjacency.ring(vertex).size());
    };
    EXPECT_EQ(metric(sheet, positions), facets_around(one) * facets_around(other));
    positions[one].x() -= 1e-6;
    EXPECT_EQ(metric(sheet, positions), 0);
}

TEST_F(SelfCrossingsOf, ASheetFoldedThroughItself) {
    for (const std::string name : {"sheet@12mm", "sheet@8mm", "sheet@4mm"}) {
        const Organ sheet = make_organ_by_formula(name);
        // The right half lifted and turned over, and on until its end goes down through the left half.
        const auto folded = [&](double degrees) {
            const Mat3 turn =
                Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Vec3::UnitY()).toRotationMatrix();
            std::vector<Vec3> positions = sheet.rest.positions;
            for (Vec3& p : positions) {
                if (p.x() > 0) p = turn * p + Vec3(0, 0, 10);
            }
            return positions;
        };
        EXPECT_EQ(metric(sheet, folded(180)), 0) << name;
        const auto expected = static_cast<double>(expected_pairs(sheet, folded(195)).size());
        EXPECT_GT(expected, 0) << name;
        EXPECT_EQ(metric(sheet, folded(195)), expected) << name;
    }
}

TEST_F(SelfCrossingsOf, ASphereWithANeedleThroughIt) {
    const Organ sphere = make_organ_by_formula("sphere@10mm");
    std::vector<Vec3> positions = sphere.rest.positions;
    positions[7] *= 0.5;
    EXPECT_EQ(metric(sphere, positions), 0) << "a dent";
    positions[7] *= -2.5;
    const auto expected = static_cast<double>(expected_pairs(sphere, positions).size());
    EXPECT_GE(expected, static_cast<double>(sphere.adjacency.ring(7).size()));
    EXPECT_EQ(metric(sphere, positions), expected) << "out on the other side";
}

TEST(SelfIntersections, AskCgalOnlyAboutFewFacets) {
    const Organ sheet = make_organ_by_formula("sheet@4mm");
    const SelfIntersections found(sheet);
    std::vector<Vec3> positions = sheet.rest.positions;
    EXPECT_TRUE(found.doubtful(positions).empty());
    for (Vec3& p : positions) p.z() -= 15 * std::exp(-p.squaredNorm() / 400);
    EXPECT_TRUE(found.doubtful(positions).empty()) << "a smooth dent";
    positions[sheet.rest.facets[100][0]].z() += 200;
    EXPECT_LT(found.doubtful(positions).size(), 40U);
}

TEST(SelfIntersections, ArePreparedOnceForAllThreads) {
    const Organ sphere = make_organ_by_formula("sphere@10mm");
    const JudgedOrgan judged(sphere);
    std::vector<const SelfIntersections*> found(4);
    std::vector<std::thread> threads;
    for (const SelfIntersections*& one : found) {
        threads.emplace_back([&] { one = &judged.self_intersections(); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const SelfIntersections* one : found) EXPECT_EQ(one, found.front());
}

/// 0 to count − 1, all as likely from the first case on.
int random_choice(std::size_t count) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, static_cast<int>(count)));
}

/// Some vertices, or those of a part, moved by a little or by much, at random or together.
std::vector<Vec3> random_displacement(const std::vector<Vec3>& rest) {
    std::vector<Vec3> positions = rest;
    const double size = std::pow(10, random_number(-2, 2));
    const auto any_vertex = [&] { return random_choice(rest.size()); };
    const Vec3& centre = rest[any_vertex()];
    const Vec3 way = size * random_direction();
    const double width = random_number(3, 40);
    switch (random_choice(4)) {
        case 0:  // a few vertices
            for (int k = 1 + random_choice(20); k > 0; --k) {
                positions[any_vertex()] += random_number(0, size) * random_direction();
            }
            break;
        case 1:  // all, each by itself
            for (Vec3& p : positions) p += random_number(0, size) * random_direction();
            break;
        case 2:  // a part together
            for (Vec3& p : positions) {
                if ((p - centre).norm() < width) p += way;
            }
            break;
        default:  // a smooth dent, somewhat rough, and two vertices at one point
            for (Vec3& p : positions) {
                p += std::exp(-(p - centre).squaredNorm() / width / width) *
                     (way + random_number(0, 0.1) * random_direction());
            }
            positions[any_vertex()] = positions[any_vertex()];
    }
    return positions;
}

Organ randomly_bent(const Organ& organ) {
    SurfaceMesh rest = organ.rest;
    rest.positions = random_displacement(rest.positions);
    return make_organ("bent", rest);
}

TEST(SelfIntersections, AreCgalsOfTheWholeMesh) {
    const Organ sphere = make_organ_by_formula("sphere@7mm"),
                sheet = make_organ_by_formula("rough-sheet@8mm"), liver = make_organ_by_formula("liver@12mm"),
                cleft = make_organ_by_formula("cleft@12mm");
    const SelfIntersections of_sphere(sphere), of_sheet(sheet), of_liver(liver), of_cleft(cleft);
    using Known = std::pair<const Organ*, const SelfIntersections*>;
    std::size_t with_pairs = 0, without = 0;
    EXPECT_TRUE(rc::check([&] {
        const auto [organ, found] = *rc::gen::element(Known{&sphere, &of_sphere}, Known{&sheet, &of_sheet},
                                                      Known{&liver, &of_liver}, Known{&cleft, &of_cleft});
        const std::vector<Vec3> positions = random_displacement(organ->rest.positions);
        const std::vector<FacetPair> expected = expected_pairs(*organ, positions);
        (expected.empty() ? without : with_pairs) += 1;
        RC_ASSERT(found->beyond_rest(positions) == expected);
    }));
    EXPECT_GT(with_pairs, 20U);
    EXPECT_GT(without, 20U);
}

TEST(SelfIntersections, AreCgalsOfTheWholeMeshLessThoseAtRest) {
    const Organ sphere = make_organ_by_formula("sphere@12mm"), sheet = make_organ_by_formula("sheet@12mm");
    EXPECT_TRUE(rc::check([&] {
        const Organ organ = randomly_bent(**rc::gen::element(&sphere, &sheet));
        const SelfIntersections found(organ);
        RC_ASSERT(found.at_rest() == cgal_self_intersections(organ.rest));
        const std::vector<Vec3> positions = random_displacement(organ.rest.positions);
        RC_ASSERT(found.beyond_rest(positions) == expected_pairs(organ, positions));
    }));
}

TEST(SelfIntersections, AreTheSameForAMovedSceneAndForOtherNumbers) {
    const Organ sphere = make_organ_by_formula("sphere@12mm"), sheet = make_organ_by_formula("sheet@12mm");
    EXPECT_TRUE(rc::check([&] {
        const Organ& organ = **rc::gen::element(&sphere, &sheet);
        // Rough, so that no two facets just touch.
        std::vector<Vec3> positions = random_displacement(organ.rest.positions);
        for (Vec3& p : positions) p += 1e-3 * random_direction();
        const std::size_t count = SelfIntersections(organ).beyond_rest(positions).size();

        const Mat3 turn = Eigen::AngleAxisd(random_number(-3, 3), random_direction()).toRotationMatrix();
        const auto moved = [&](std::vector<Vec3> all) {
            for (Vec3& p : all) p = turn * p + Vec3(10, -20, 30);
            return all;
        };
        const Organ moved_organ =
            make_organ("moved", {.positions = moved(organ.rest.positions), .facets = organ.rest.facets});
        RC_ASSERT(SelfIntersections(moved_organ).beyond_rest(moved(positions)).size() == count);

        std::mt19937 numbers(*rc::gen::arbitrary<unsigned>());
        std::vector<Index> places(positions.size());
        std::iota(places.begin(), places.end(), 0);
        std::ranges::shuffle(places, numbers);
        SurfaceMesh shuffled = organ.rest;
        std::vector<Vec3> shuffled_positions = positions;
        for (std::size_t k = 0; k < places.size(); ++k) {
            shuffled.positions[places[k]] = organ.rest.positions[k];
            shuffled_positions[places[k]] = positions[k];
        }
        for (Facet& facet : shuffled.facets) {
            for (Index& vertex : facet) vertex = places[vertex];
            std::ranges::rotate(facet, facet.begin() + 1);
        }
        std::ranges::shuffle(shuffled.facets, numbers);
        const Organ other = make_organ("shuffled", shuffled);
        RC_ASSERT(SelfIntersections(other).beyond_rest(shuffled_positions).size() == count);
    }));
}

}  // namespace
}  // namespace trocar
