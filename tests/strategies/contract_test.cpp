#include "tests/strategies/contract.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/strategies/scenes.h"
#include "tests/strategies/variants.h"

namespace trocar::contract {
namespace {

class EveryStrategy : public testing::TestWithParam<Variant> {
  protected:
    Subject subject_{find_strategy(GetParam().name).description,
                     [] { return make_strategy(GetParam().name, GetParam().options); }};
    static constexpr std::uint64_t scenes = 20;
};

TEST_P(EveryStrategy, AnswersWellFormed) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_well_formed(subject_, random_scene(seed)), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, StandsDegenerateScenes) {
    const Scene another = random_scene(1);
    for (const std::string& tool : contract_tools()) {
        for (const auto& [name, scene] : degenerate_scenes(tool)) {
            ASSERT_FALSE(scene.detected.collided.empty()) << tool << ": " << name;
            EXPECT_EQ(violation_of_well_formed(subject_, scene), "") << tool << ": " << name;
            EXPECT_EQ(violation_of_clearing(subject_, scene), "") << tool << ": " << name;
            EXPECT_EQ(violation_of_leaving_others(subject_, scene), "") << tool << ": " << name;
            EXPECT_EQ(violation_of_repeatability(subject_, scene, another), "") << tool << ": " << name;
        }
    }
}

TEST_P(EveryStrategy, IsQuietWithoutContact) {
    for (const auto& [name, scene] : scenes_without_contact()) {
        EXPECT_EQ(violation_of_quiet_without_contact(subject_, scene), "") << name;
    }
}

TEST_P(EveryStrategy, ClearsTheToolWherePromised) {
    EXPECT_TRUE(rc::check("every collided vertex leaves the tool", [&] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        const auto tool = *rc::gen::elementOf(contract_tools());
        const std::string violation = violation_of_clearing(subject_, random_scene(seed, tool));
        if (!violation.empty()) RC_FAIL(violation);
    }));
}

TEST_P(EveryStrategy, LeavesOthersAloneWherePromised) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_leaving_others(subject_, random_scene(seed)), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, IsEquivariantUnderRigidMotion) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto angle = static_cast<double>(seed);
        const Pose by{.rotation = Eigen::AngleAxisd(angle, Vec3(1, angle, 2).normalized()).toRotationMatrix(),
                      .position = {3 * angle, -70, 11}};
        ASSERT_EQ(violation_of_rigid_equivariance(subject_, random_scene(seed), by), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, IsEquivariantUnderScaling) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        for (const double factor : {0.001, 1.7, 64.0}) {
            ASSERT_EQ(violation_of_scale_equivariance(subject_, random_scene(seed), factor), "")
                << "seed " << seed << ", factor " << factor;
        }
    }
}

TEST_P(EveryStrategy, DoesNotCareHowVerticesAreNumbered) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_vertex_numbering(subject_, random_scene(seed), seed), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, DoesNotCareHowFacetsAreNumberedWherePromised) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_facet_numbering(subject_, random_scene(seed), seed), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, RepeatsItselfToTheBit) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        ASSERT_EQ(violation_of_repeatability(subject_, random_scene(seed), random_scene(seed + 100)), "")
            << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryStrategy, testing::ValuesIn(all_variants()),
                         [](const testing::TestParamInfo<Variant>& the) {
                             std::string name = the.param.label;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace trocar::contract
