// tool_volume_inside and tool_points_inside against other ways to find them, on organs of all shapes.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "judged_steps.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using Positions = JudgedSteps::Positions;
using CgalMesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

CgalMesh to_cgal(const Positions& positions, const std::vector<Facet>& facets) {
    CgalMesh mesh;
    for (const Vec3& p : positions) mesh.add_vertex({p.x(), p.y(), p.z()});
    using Vertex = CgalMesh::Vertex_index;
    for (const auto& [a, b, c] : facets) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
    return mesh;
}

double volume_by_corefinement(const JudgedState& state) {
    CgalMesh organ = to_cgal(state.in_tool(), state.organ().facets());
    CgalMesh tool = to_cgal(state.tool().mesh().positions, state.tool().mesh().facets);
    CgalMesh shared;
    if (!pmp::corefine_and_compute_intersection(organ, tool, shared)) throw std::runtime_error("no solid");
    return is_empty(shared) ? 0.0 : pmp::volume(shared);
}

/// By the solid angle of every facet (Van Oosterom and Strackee).
int winding_number(const Positions& positions, const std::vector<Facet>& facets, const Vec3& point) {
    double turned = 0;
    for (const Facet& facet : facets) {
        const Vec3 a = positions[facet[0]] - point, b = positions[facet[1]] - point,
                   c = positions[facet[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        turned += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
    }
    return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
}

/// Turned anyhow, with some point of the tool's surface within 3 mm of some vertex of the organ.
Pose random_pose(const JudgedSteps& scene) {
    const auto one_of = [](const Positions& points) {
        return points[*rc::gen::inRange<std::size_t>(0, points.size())];
    };
    const Mat3 rotation =
        Eigen::AngleAxisd(random_number(0, 2 * std::numbers::pi), random_direction()).toRotationMatrix();
    const Vec3 meet = one_of(scene.rest()) + random_number(-3, 3) * random_direction();
    return {.rotation = rotation, .position = meet - rotation * one_of(scene.judged_tool().points())};
}

struct Inside {
    double volume;  // mm³
    double points;
};

Inside inside(const JudgedSteps& scene, const Positions& positions, const Pose& pose) {
    const Judged step = scene.step(pose, positions, positions, positions);
    return {.volume = value("tool_volume_inside", Moment::handled, step),
            .points = value("tool_points_inside", Moment::handled, step)};
}

class OrganAndTool : public testing::TestWithParam<std::pair<const char*, const char*>> {
  protected:
    const JudgedSteps scene_{make_organ_by_formula(GetParam().first),
                             make_tool_by_formula(GetParam().second)};
};

TEST_P(OrganAndTool, SharesTheVolumeThatCorefinementFinds) {
    rc::check([this] {
        const JudgedState state = scene_.state(scene_.rest(), random_pose(scene_));
        const double expected = volume_by_corefinement(state);
        RC_CLASSIFY(expected > 0);
        const Inside found = inside(scene_, scene_.rest(), state.pose());
        RC_ASSERT(std::abs(found.volume - expected) <= 1e-6 + 1e-9 * expected);
    });
}

TEST_P(OrganAndTool, HasThePointsInsideThatCgalFindsInside) {
    rc::check([this] {
        const JudgedState state = scene_.state(scene_.rest(), random_pose(scene_));
        const SurfaceMesh organ{state.in_tool(), scene_.organ().rest.facets};
        const SurfaceQueries queries(organ);
        const auto expected = std::ranges::count_if(
            scene_.judged_tool().points(), [&](const Vec3& point) { return queries.contains(point); });
        RC_CLASSIFY(expected > 0);
        RC_ASSERT(inside(scene_, scene_.rest(), state.pose()).points == expected);
    });
}
INSTANTIATE_TEST_SUITE_P(Organs, OrganAndTool,
                         testing::Values(std::pair{"sphere@10mm", "prism-12"},
                                         std::pair{"gallbladder@6mm", "pointed-prism-12"},
                                         std::pair{"liver@10mm", "needle"},
                                         std::pair{"sphere@8mm", "grasper"}));

/// An organ whose vertices are thrown about by up to 12 mm, so that its surface crosses itself in many places
/// and has parts of winding number −1, 2 and 3, and the tool in the middle of it.
class CrumpledOrgan : public testing::TestWithParam<int> {
  protected:
    std::mt19937 random_{static_cast<std::mt19937::result_type>(GetParam())};
    const JudgedSteps scene_{make_organ_by_formula("sphere@10mm"), make_prism(5, 8, 40)};
    const Positions positions_ = crumpled();
    const Pose pose_{.rotation = turn(), .position = 30 * direction()};

    Vec3 direction() {
        std::normal_distribution<double> normal;
        return Vec3(normal(random_), normal(random_), normal(random_)).normalized();
    }
    Mat3 turn() { return Eigen::AngleAxisd(uniform() * std::numbers::pi, direction()).toRotationMatrix(); }
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    Positions crumpled() {
        Positions positions = scene_.rest();
        for (Vec3& p : positions) p += 12 * uniform() * direction();
        return positions;
    }
};

TEST_P(CrumpledOrgan, HasInsideWhatSolidAnglesSay) {
    const JudgedTool& tool = scene_.judged_tool();
    const JudgedState state = scene_.state(positions_, pose_);
    const auto is_inside = [&](const Vec3& p) {
        return winding_number(state.in_tool(), scene_.organ().rest.facets, p) >= 1;
    };
    const Inside found = inside(scene_, positions_, pose_);
    EXPECT_EQ(found.points, std::ranges::count_if(tool.points(), is_inside));

    // The volume by a sample at random in each cell of the tool's box.
    const Vec3 cells(16, 16, 40), cell = tool.box().size().cwiseQuotient(cells);
    int counted = 0;
    for (int i = 0; i < cells.x(); ++i) {
        for (int j = 0; j < cells.y(); ++j) {
            for (int k = 0; k < cells.z(); ++k) {
                const Vec3 within(i + uniform(), j + uniform(), k + uniform());
                const Vec3 at = tool.box().low + within.cwiseProduct(cell);
                if (tool.contains(at) && is_inside(at)) ++counted;
            }
        }
    }
    const double sampled = counted * cell.prod();
    EXPECT_GT(sampled, 300);
    EXPECT_NEAR(found.volume, sampled, 0.01 * sampled + 20) << "20 mm³: what sampling misses";
}

TEST_P(CrumpledOrgan, StaysTheSameInARigidMotionOfTheWholeScene) {
    const Inside still = inside(scene_, positions_, pose_);
    const Mat3 rotation = turn();
    const Vec3 shift = 100 * direction();
    Positions moved = positions_;
    for (Vec3& p : moved) p = rotation * p + shift;
    const Inside after =
        inside(scene_, moved,
               {.rotation = rotation * pose_.rotation, .position = rotation * pose_.position + shift});
    EXPECT_NEAR(after.volume, still.volume, 1e-9 * still.volume);
    EXPECT_EQ(after.points, still.points);
}

TEST_P(CrumpledOrgan, StaysTheSameWhenVerticesAndFacetsAreRenumbered) {
    const Inside as_it_was = inside(scene_, positions_, pose_);
    SurfaceMesh rest = scene_.organ().rest;
    std::vector<Index> numbers(rest.positions.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::shuffle(numbers.begin(), numbers.end(), random_);
    Positions positions(positions_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        rest.positions[numbers[k]] = scene_.rest()[k];
        positions[numbers[k]] = positions_[k];
    }
    for (Facet& facet : rest.facets) {
        for (Index& vertex : facet) vertex = numbers[vertex];
        std::ranges::rotate(facet, facet.begin() + 1);
    }
    std::shuffle(rest.facets.begin(), rest.facets.end(), random_);
    const JudgedSteps renumbered(make_organ("renumbered", rest), make_prism(5, 8, 40));
    const Inside after = inside(renumbered, positions, pose_);
    EXPECT_NEAR(after.volume, as_it_was.volume, 1e-12 * as_it_was.volume);
    EXPECT_EQ(after.points, as_it_was.points);
}
INSTANTIATE_TEST_SUITE_P(Seeds, CrumpledOrgan, testing::Range(1, 4));

}  // namespace
}  // namespace trocar
