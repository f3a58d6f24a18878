// Detection against brute force with the same predicates, as sets, at every step of random scenes.

#include <algorithm>

#include <gtest/gtest.h>

#include "common/cycle/cycle.h"
#include "common/geometry/flat_edges.h"
#include "common/geometry/organ_shapes.h"
#include "common/geometry/predicates.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/prepared_scene.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

/// No patches, no boxes, no planes: exact signs of every vertex and facet against every facet of the tool.
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
    [[nodiscard]] bool is_inside(const Vec3& point) const {
        for (std::size_t f = 0; f < tool_.mesh.facets.size(); ++f) {
            const Corners plane = tool_facet(f);
            if (orientation_sign(plane[0], plane[1], plane[2], point) >= 0) return false;
        }
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

class RandomScene : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomScene, DetectionEqualsBruteForceAtEveryStep) {
    const std::uint64_t seed = GetParam();
    const Organ organ = make_organ_by_formula(seed % 3 == 0   ? "sheet@4mm"
                                              : seed % 3 == 1 ? "sphere@4mm"
                                                              : "sphere@5mm");
    const Tool tool = make_prism(3 + static_cast<int>(seed % 6), 3 + static_cast<double>(seed % 4), 40);
    const double speed = seed % 2 == 0 ? 120 : 400;
    const SurfaceQueries queries(organ.rest);
    const PreparedScene scene = prepare_scene(find_scene("penetration"), {.organ = organ,
                                                                          .organ_queries = queries,
                                                                          .tool = tool,
                                                                          .speed = speed,
                                                                          .dt = 1.0 / 30,
                                                                          .seed = seed});
    const auto strategy = make_strategy(seed % 4 < 2 ? "fuzzy-per-vertex" : "nearest-face");
    const BruteForce brute_force(organ, tool);

    const Release release = seed % 5 == 0 ? Release::step : Release::contact;
    Cycle cycle(organ, tool, scene.start, {.release = release}, {});
    std::size_t collided = 0, crossed = 0;
    for (const Pose& pose : scene.poses) {
        cycle.move(pose);
        cycle.detect();
        const Detected expected = brute_force.detect(cycle.positions(), pose);
        ASSERT_EQ(cycle.detected().collided, expected.collided);
        ASSERT_EQ(cycle.detected().crossed, expected.crossed);
        collided += expected.collided.size();
        crossed += expected.crossed.size();
        for (const Index v : expected.collided) {
            ASSERT_TRUE(std::ranges::binary_search(cycle.detected().near_vertices, v))
                << "collided but not near";
        }
        cycle.handle(
            [&](const Contact& contact, Response& response) { strategy->handle(contact, response); });
        cycle.deform();
    }
    EXPECT_GT(collided, 0U);
    EXPECT_GT(crossed, 0U);
}
INSTANTIATE_TEST_SUITE_P(Fifty, RandomScene, testing::Range<std::uint64_t>(1, 51));

}  // namespace
}  // namespace trocar
