#include <algorithm>

#include <gtest/gtest.h>

#include "experiments/scenes/placement.h"
#include "strategies/registry.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/bench_tools.h"
#include "tests/benchmarks/bullet_peer.h"
#include "tests/benchmarks/cgal_peer.h"
#include "tests/benchmarks/fcl_peer.h"

namespace trocar {
namespace {

Pose at_depth(const Placement& placement, double depth) {
    return upright_pose(placement, placement.entry - depth * placement.normal);
}

TEST(BulletPeer, IsDentedAsDeepAsItsCylinderGoes) {
    const BenchScene& on = scene_on(bench_organs.at(1), "penetration");
    const Placement& placement = on.scene.placement;
    for (const auto setup :
         {BulletPeer::Setup::in_order, BulletPeer::Setup::shuffled, BulletPeer::Setup::fresh}) {
        BulletPeer bullet(on.organ, placement, at_depth(placement, -1), SpringSettings{}.substeps, setup);
        bullet.step(at_depth(placement, -1), CycleSettings{}.dt());
        EXPECT_EQ(bullet.contacts(), 0);
        EXPECT_NEAR(bullet.dent(), 0, 1e-3);
        constexpr int steps = 15;
        for (int step = 0; step < steps; ++step) {
            bullet.step(at_depth(placement, std::min(12.0, 3.0 * step)), CycleSettings{}.dt());
        }
        EXPECT_NEAR(bullet.dent(), 12, 1);
        EXPECT_GT(bullet.contacts(), 5);
        EXPECT_LT(bullet.contacts(), 40);
    }
}

TEST(FclPeer, FindsTheFacetsThatDetectionFinds) {
    const BenchScene& on = scene_on(bench_organs.at(1), "penetration");
    FclPeer fcl(on.organ);
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
    const auto strategy = make_strategy("fuzzy-per-vertex");
    std::size_t steps = 0;
    run_scene(cycle, on.scene, *strategy, {.detected = [&](const Cycle& at) {
                  const FclPeer::Found found = fcl.detect(at.positions(), at.tool().pose());
                  const std::size_t ours = at.detected().crossed.size();
                  // Its cylinder is round about the prism: it touches at least these, and some more.
                  EXPECT_GE(found.facets, ours);
                  EXPECT_LE(found.facets, 2 * ours + 30);
                  ++steps;
              }});
    EXPECT_GT(steps, 10);
}

TEST(CgalPeer, AgreesWithTheSolid) {
    for (const BenchTool& made : bench_tools) {
        const Tool tool = made.make();
        const CgalPeer cgal(tool.mesh);
        const Box box = tool.solid.box();
        int inside = 0;
        constexpr int steps = 30;
        for (int k = 0; k < steps * steps * steps; ++k) {
            const int x = k % steps, y = k / steps % steps, z = k / steps / steps;
            const Vec3 part = Vec3(x, y, z) / steps;
            const Vec3 point = box.low + part.cwiseProduct(box.size());
            EXPECT_EQ(cgal.contains(point), tool.solid.contains(point));
            inside += cgal.contains(point) ? 1 : 0;
        }
        EXPECT_GT(inside, 100) << made.name;
    }
}

}  // namespace
}  // namespace trocar
