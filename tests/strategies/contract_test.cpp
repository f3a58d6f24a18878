#include "tests/strategies/contract.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "strategies/registry.h"

namespace trocar::contract {
namespace {

/// A strategy with one choice of its options.
struct Variant {
    std::string name;
    Options options;
    std::string label;
};

void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.label; }

/// Every registered strategy: with its defaults, and with each option at each of its other values.
std::vector<Variant> all_variants() {
    std::vector<Variant> variants;
    for (const StrategyEntry& entry : all_strategies()) {
        const Description& description = entry.description;
        variants.push_back({description.name, {}, description.name});
        const auto add = [&](const OptionSpec& spec, const OptionValue& value, const std::string& shown) {
            variants.push_back(
                {description.name, {{spec.name, value}}, description.name + "__" + spec.name + "_" + shown});
        };
        for (const OptionSpec& spec : description.options) {
            if (std::holds_alternative<bool>(spec.default_value)) {
                const bool other = !std::get<bool>(spec.default_value);
                add(spec, other, other ? "true" : "false");
            } else if (std::holds_alternative<double>(spec.default_value)) {
                add(spec, spec.low, "low");
                add(spec, spec.high, "high");
            } else {
                for (const std::string& choice : spec.choices) {
                    if (OptionValue(choice) != spec.default_value) add(spec, choice, choice);
                }
            }
        }
    }
    return variants;
}

class EveryStrategy : public testing::TestWithParam<Variant> {
  protected:
    Maker make_ = [] { return make_strategy(GetParam().name, GetParam().options); };
    static constexpr std::uint64_t scenes = 40;
};

TEST_P(EveryStrategy, AnswersWellFormed) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_well_formed(make_, random_scene(seed)), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, StandsDegenerateScenes) {
    for (const auto& [name, scene] : degenerate_scenes()) {
        ASSERT_FALSE(scene.detected.collided.empty()) << name;
        EXPECT_EQ(violation_of_well_formed(make_, scene), "") << name;
        EXPECT_EQ(violation_of_promises(make_, scene), "") << name;
        EXPECT_EQ(violation_of_repeatability(make_, scene, random_scene(1)), "") << name;
    }
}

TEST_P(EveryStrategy, IsQuietWithoutContact) { EXPECT_EQ(violation_of_quiet_without_contact(make_), ""); }

TEST_P(EveryStrategy, KeepsItsPromises) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_promises(make_, random_scene(seed)), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, IsEquivariantUnderRigidMotion) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto angle = static_cast<double>(seed);
        const Pose by{.rotation = Eigen::AngleAxisd(angle, Vec3(1, angle, 2).normalized()).toRotationMatrix(),
                      .position = {3 * angle, -70, 11}};
        ASSERT_EQ(violation_of_rigid_equivariance(make_, random_scene(seed), by), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, IsEquivariantUnderScaling) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        for (const double factor : {0.001, 1.7, 64.0}) {
            ASSERT_EQ(violation_of_scale_equivariance(make_, random_scene(seed), factor), "")
                << "seed " << seed << ", factor " << factor;
        }
    }
}

TEST_P(EveryStrategy, DoesNotCareHowVerticesAreNumbered) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_vertex_numbering(make_, random_scene(seed), seed), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, DoesNotCareHowFacetsAreNumberedWherePromised) {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        ASSERT_EQ(violation_of_facet_numbering(make_, random_scene(seed), seed), "") << "seed " << seed;
    }
}

TEST_P(EveryStrategy, RepeatsItselfToTheBit) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        ASSERT_EQ(violation_of_repeatability(make_, random_scene(seed), random_scene(seed + 100)), "")
            << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryStrategy, testing::ValuesIn(all_variants()),
                         [](const testing::TestParamInfo<Variant>& the) {
                             std::string name = the.param.label;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

/// A strategy that does to each contact what it is told.
class Scripted final : public Strategy {
  public:
    using Script = std::function<void(const Contact&, Response&)>;
    explicit Scripted(Script script) : script_(std::move(script)) {}
    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = true, .facet_order_free = true};
    }
    void handle(const Contact& contact, Response& response) override { script_(contact, response); }

  private:
    Script script_;
};

Maker scripted(Scripted::Script script) {
    return [script = std::move(script)] { return std::make_unique<Scripted>(script); };
}

TEST(TheContract, FindsOutWhatIsNotFinite) {
    const Maker bad = scripted([](const Contact& contact, Response& response) {
        response.displacements.push_back({contact.collided.front(), Vec3(0, std::nan(""), 0)});
    });
    EXPECT_NE(violation_of_well_formed(bad, random_scene(1)), "");
}

TEST(TheContract, FindsOutWhatNamesAVertexTwiceOrOneThatIsNot) {
    const Maker twice = scripted([](const Contact&, Response& response) {
        response.displacements = {{0, Vec3(1, 0, 0)}, {0, Vec3(1, 0, 0)}};
    });
    const Maker beyond = scripted([](const Contact& contact, Response& response) {
        response.displacements = {{static_cast<Index>(contact.positions.size()), Vec3(1, 0, 0)}};
    });
    EXPECT_NE(violation_of_well_formed(twice, random_scene(1)), "");
    EXPECT_NE(violation_of_well_formed(beyond, random_scene(1)), "");
}

TEST(TheContract, FindsOutWhatActsWithoutContact) {
    const Maker bad = scripted([](const Contact&, Response& response) {
        response.displacements = {{0, Vec3(1, 0, 0)}};
    });
    EXPECT_NE(violation_of_quiet_without_contact(bad), "");
    EXPECT_NE(violation_of_promises(bad, random_scene(1)), "") << "it moves a vertex that is not collided";
}

TEST(TheContract, FindsOutWhatLeavesVerticesInTheTool) {
    const Maker lazy = scripted([](const Contact&, Response&) {});
    const Maker exact = scripted([](const Contact& contact, Response& response) {
        for (const Index vertex : contact.collided) {
            const NearestFace nearest = contact.tool.nearest_face(contact.positions[vertex]);
            // To a tenth of the clearance only.
            const double way = 0.1 * contact.clearance - nearest.signed_distance;
            response.displacements.push_back({vertex, way * nearest.normal});
        }
    });
    EXPECT_NE(violation_of_promises(lazy, random_scene(1)), "");
    EXPECT_NE(violation_of_promises(exact, random_scene(1)), "");
}

TEST(TheContract, FindsOutWhatIsNotEquivariant) {
    const Maker upwards = scripted([](const Contact& contact, Response& response) {
        for (const Index vertex : contact.collided) response.displacements.push_back({vertex, Vec3(0, 0, 5)});
    });
    const Pose quarter{.rotation = Eigen::AngleAxisd(1.5, Vec3::UnitX()).toRotationMatrix()};
    EXPECT_NE(violation_of_rigid_equivariance(upwards, random_scene(1), quarter), "");
    EXPECT_NE(violation_of_scale_equivariance(upwards, random_scene(1), 2), "");
}

TEST(TheContract, FindsOutWhatDependsOnNumbers) {
    const Maker by_vertex = scripted([](const Contact& contact, Response& response) {
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, vertex * Vec3(1, 0, 0)});
        }
    });
    const Maker by_facet = scripted([](const Contact& contact, Response& response) {
        for (const Index vertex : contact.collided) {
            const Index first = contact.organ.adjacency.ring(vertex).front();
            response.displacements.push_back({vertex, contact.organ.rest_normals[first]});
        }
    });
    EXPECT_NE(violation_of_vertex_numbering(by_vertex, random_scene(1), 7), "");
    EXPECT_NE(violation_of_facet_numbering(by_facet, random_scene(2), 7), "");
}

TEST(TheContract, FindsOutWhatRemembers) {
    auto calls = std::make_shared<int>(0);
    const Maker bad = [calls] {
        return std::make_unique<Scripted>([calls](const Contact& contact, Response& response) {
            response.displacements.push_back({contact.collided.front(), Vec3(++*calls, 0, 0)});
        });
    };
    EXPECT_NE(violation_of_repeatability(bad, random_scene(1), random_scene(2)), "");
}

}  // namespace
}  // namespace trocar::contract
