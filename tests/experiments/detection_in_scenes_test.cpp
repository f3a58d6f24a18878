// Detection against brute force with the same predicates, as sets, at every step of random scenes.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/cycle/cycle.h"
#include "common/geometry/flat_edges.h"
#include "common/geometry/organ_shapes.h"
#include "common/geometry/predicates.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/prepared_scene.h"
#include "stage.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

/// No patches, no trees, no rounded planes: exact signs of every vertex and facet against every facet of the
/// tool.
class BruteForce {
  public:
    BruteForce(const Organ& organ, const Tool& tool)
        : organ_(organ),
          tool_(tool),
          flat_(flat_edges(tool.mesh, Adjacency(tool.mesh.positions.size(), tool.mesh.facets))) {}

    [[nodiscard]] Detected detect(std::span<const Vec3> positions, const Pose& pose) const {
        std::vector<Vec3> judged;
        for (const Vec3& position : positions) judged.push_back(judged_position(pose, position));
        std::vector<bool> inside;
        Detected found;
        for (std::size_t v = 0; v < judged.size(); ++v) {
            inside.push_back(is_inside(judged[v]));
            if (inside[v]) found.collided.push_back(static_cast<Index>(v));
        }
        for (std::size_t f = 0; f < organ_.rest.facets.size(); ++f) {
            const auto [a, b, c] = organ_.rest.facets[f];
            if (inside[a] || inside[b] || inside[c] || crosses({judged[a], judged[b], judged[c]})) {
                found.crossed.push_back(static_cast<Index>(f));
            }
        }
        return found;
    }

  private:
    [[nodiscard]] Corners tool_facet(std::size_t f) const {
        const auto [a, b, c] = tool_.mesh.facets[f];
        return {tool_.mesh.positions[a], tool_.mesh.positions[b], tool_.mesh.positions[c]};
    }
    /// By exact signs: whether a segment from the point to one far away pierces an odd number of facets.
    /// Where it meets an edge another one is taken; every segment from a point of the surface meets
    /// something.
    [[nodiscard]] bool is_inside(const Vec3& point) const {
        if (!bounding_box(tool_.mesh.positions).contains(point)) return false;
        for (const Vec3& far : {Vec3(501, 333, 77), Vec3(-301, 444, -99), Vec3(99, -555, 1001)}) {
            int pierced = 0;
            bool in_general_position = true;
            for (std::size_t f = 0; f < tool_.mesh.facets.size() && in_general_position; ++f) {
                const std::optional<bool> pierces = pierces_facet(point, far, tool_facet(f));
                in_general_position = pierces.has_value();
                pierced += pierces.value_or(false) ? 1 : 0;
            }
            if (in_general_position) return pierced % 2 == 1;
        }
        return false;
    }
    /// None where the segment meets a line through two of the facet's corners, or its own end the facet.
    static std::optional<bool> pierces_facet(const Vec3& p, const Vec3& q, const Corners& facet) {
        const auto& [a, b, c] = facet;
        const int p_side = orientation_sign(a, b, c, p), q_side = orientation_sign(a, b, c, q);
        if (p_side == q_side && p_side != 0) return false;
        const std::array around{orientation_sign(p, q, a, b), orientation_sign(p, q, b, c),
                                orientation_sign(p, q, c, a)};
        const bool meets_a_line = std::ranges::count(around, 0) > 0;
        if (!meets_a_line && (around[0] != around[1] || around[1] != around[2])) return false;
        if (meets_a_line || p_side == 0 || q_side == 0) return std::nullopt;
        return true;
    }
    [[nodiscard]] bool crosses(const Corners& facet) const {
        for (std::size_t f = 0; f < tool_.mesh.facets.size(); ++f) {
            if (facets_cross(facet, tool_facet(f), flat_[f])) return true;
        }
        return false;
    }

    const Organ& organ_;
    const Tool& tool_;
    std::vector<std::array<bool, 3>> flat_;
};

/// What was found over a scene.
struct Found {
    std::size_t collided = 0, crossed = 0;
};

/// Runs the scene and compares at every step what detection finds with what brute force finds.
void compare_at_every_step(const Organ& organ, const Tool& tool, const PreparedScene& scene,
                           Strategy& strategy, Release release, Found& found) {
    const BruteForce brute_force(organ, tool);
    Cycle cycle(organ, tool, scene.start, {.release = release}, {});
    for (const Pose& pose : scene.poses) {
        cycle.move(pose);
        cycle.detect();
        const Detected expected = brute_force.detect(cycle.positions(), pose);
        ASSERT_EQ(cycle.detected().collided, expected.collided);
        ASSERT_EQ(cycle.detected().crossed, expected.crossed);
        found.collided += expected.collided.size();
        found.crossed += expected.crossed.size();
        for (const Index v : expected.collided) {
            ASSERT_TRUE(std::ranges::binary_search(cycle.detected().near_vertices, v))
                << "collided but not near";
        }
        cycle.handle([&](const Contact& contact, Response& response) { strategy.handle(contact, response); });
        cycle.deform();
    }
}

class RandomScene : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomScene, DetectionEqualsBruteForceAtEveryStep) {
    const std::uint64_t seed = GetParam();
    const Organ organ = make_organ_by_formula(seed % 3 == 0   ? "sheet@4mm"
                                              : seed % 3 == 1 ? "sphere@4mm"
                                                              : "sphere@5mm");
    const Tool tool = seed % 7 == 0
                          ? make_grasper()
                          : make_prism(3 + static_cast<int>(seed % 6), 3 + static_cast<double>(seed % 4), 40);
    const double speed = seed % 2 == 0 ? 120 : 400;
    const SurfaceQueries queries(organ.rest);
    const PreparedScene scene = prepare_scene(find_scene("penetration"), {.organ = organ,
                                                                          .organ_queries = queries,
                                                                          .tool = tool,
                                                                          .speed = speed,
                                                                          .dt = 1.0 / 30,
                                                                          .seed = seed});
    const auto strategy = make_strategy(seed % 4 < 2 ? "fuzzy-per-vertex" : "nearest-face");
    Found found;
    compare_at_every_step(organ, tool, scene, *strategy, seed % 5 == 0 ? Release::step : Release::contact,
                          found);
    if (tool.solid.convex() && tool.radius >= 5) {
        EXPECT_GT(found.collided, 0U) << "a slim tool or jaw may pass between the vertices, this may not";
    }
    EXPECT_GT(found.crossed, 0U);
}
INSTANTIATE_TEST_SUITE_P(Fifty, RandomScene, testing::Range<std::uint64_t>(1, 51));

class SceneOfTheList : public testing::TestWithParam<std::string> {};

TEST_P(SceneOfTheList, DetectionEqualsBruteForceAtEveryStep) {
    const SceneEntry& scene = find_scene(GetParam());
    for (const char* organ : {"sphere@5mm", "tube@6mm", "cleft@6mm"}) {
        const Stage stage(organ);
        const SceneInputs inputs = stage.inputs(200, 2);
        if (!unsuited(scene, inputs).empty()) continue;
        Found found;
        compare_at_every_step(stage.organ, stage.tool, prepare_scene(scene, inputs),
                              *make_strategy("fuzzy-per-vertex"), Release::contact, found);
        if (scene.name == "extraction") continue;  // what only leaves may cross nothing
        EXPECT_GT(found.crossed, 0U) << organ;
    }
}
INSTANTIATE_TEST_SUITE_P(All, SceneOfTheList, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const SceneEntry& scene : all_scenes()) {
                                 if (!scene.needs_recording) names.push_back(scene.name);
                             }
                             return names;
                         }()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace trocar
