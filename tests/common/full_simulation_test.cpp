// Without sleep the integrator is the plain one, to the bit, however springs and vertices lie in memory.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "tests/common/plain_xpbd.h"

namespace trocar {
namespace {

/// Both integrators, from the same start under the same loads.
class BothWays {
  public:
    BothWays(const SpringNetwork& network, const OrganState& start, const Integration& settings)
        : settings_(settings), integrator_(network, start, settings), plain_(start) {}

    void put(Index vertex, const Vec3& position) {
        integrator_.put(vertex, position);
        plain_.positions[vertex] = position;
    }
    void step(const StepLoad& load) {
        integrator_.step(load);
        plain_step(integrator_.network(), settings_, load, plain_);
    }
    void expect_the_same_bits() const {
        ASSERT_EQ(integrator_.state().positions, plain_.positions);
        ASSERT_EQ(integrator_.state().velocities, plain_.velocities);
    }

  private:
    Integration settings_;
    XpbdIntegrator integrator_;
    OrganState plain_;
};

class FullSimulation : public testing::TestWithParam<const char*> {
  protected:
    const Organ organ_ = make_organ_by_formula(GetParam());
    SpringNetwork network_ = surface_springs(organ_, {});
    std::mt19937 generator_{8};  // NOLINT(bugprone-random-generator-seed): the same in every run

    double number() { return std::uniform_real_distribution<>(-1, 1)(generator_); }
    Vec3 point() { return {number(), number(), number()}; }
    Index vertex() {
        return std::uniform_int_distribution<Index>(0,
                                                    static_cast<Index>(network_.rest.size()) - 1)(generator_);
    }
    [[nodiscard]] OrganState at_rest() const {
        return {network_.rest, std::vector<Vec3>(network_.rest.size(), Vec3::Zero())};
    }

    /// Holds, pushes and confines vertices at random, moves some, fixed ones too, and lets go again.
    void stir(BothWays& both) {
        for (int k = 0; k < 12; ++k) {
            std::vector<Index> held;
            for (int i = 0; i < 20 && k % 4 != 3; ++i) held.push_back(vertex());
            std::ranges::sort(held);
            held.erase(std::ranges::unique(held).begin(), held.end());
            for (const Index v : held) both.put(v, network_.rest[v] + 5 * point());
            std::vector<VertexForce> forces;
            std::vector<HalfSpace> half_spaces;
            for (int i = 0; i < 10; ++i) {
                const Index pushed = vertex(), confined = vertex();
                if (std::ranges::none_of(forces, [&](const auto& f) { return f.vertex == pushed; })) {
                    forces.push_back({pushed, 1e5 * point()});
                }
                half_spaces.push_back({confined, network_.rest[confined] + point(), point().normalized()});
            }
            both.step({.kinematic = held, .forces = forces, .half_spaces = half_spaces});
            both.expect_the_same_bits();
        }
    }
};

TEST_P(FullSimulation, IsThePlainOne) {
    BothWays both(network_, at_rest(), {});
    stir(both);
}

TEST_P(FullSimulation, IsThePlainOneInWhateverOrderSpringsAreNamed) {
    std::ranges::shuffle(network_.springs, generator_);
    BothWays both(network_, at_rest(), {.dt = 0.001, .damping = 20, .substeps = 3});
    stir(both);
}

TEST_P(FullSimulation, IsThePlainOneWhateverThePatches) {
    std::vector<Index> vertices;
    for (const auto& patch : network_.patches) vertices.insert(vertices.end(), patch.begin(), patch.end());
    std::ranges::shuffle(vertices, generator_);
    network_.patches = {{vertices.begin(), vertices.begin() + 7}, {}, {vertices.begin() + 9, vertices.end()}};
    OrganState start = at_rest();
    for (Vec3& position : start.positions) position += point();
    for (Vec3& velocity : start.velocities) velocity += 100 * point();
    BothWays both(network_, start, {});
    stir(both);
}

INSTANTIATE_TEST_SUITE_P(ByFormula, FullSimulation,
                         testing::Values("sphere@6mm", "sheet@8mm", "gallbladder@4mm", "cleft@8mm"),
                         [](const testing::TestParamInfo<const char*>& organ) {
                             std::string name = organ.param;
                             std::ranges::replace(name, '@', '_');
                             return name;
                         });

TEST(SpringKernels, OfThisProcessorAndOfEveryProcessorHaveTheSameBits) {
    std::mt19937 generator(8);  // NOLINT(bugprone-random-generator-seed): the same in every run
    std::uniform_real_distribution<> number(-3, 3);
    constexpr std::uint32_t springs = 11, idle = 2 * springs;
    std::vector<Slot> positions(idle + 1, Slot(0, 0, 0, 0));
    std::vector<SpringLayout::Spring> level;
    for (std::uint32_t k = 0; k < springs; ++k) {
        for (const std::uint32_t slot : {2 * k, 2 * k + 1}) {
            positions[slot] =
                Slot(number(generator), number(generator), number(generator), std::abs(number(generator)));
        }
        level.push_back({.a = 2 * k, .b = 2 * k + 1, .level = 1, .rest_length = 2, .compliance = 0.5});
    }
    positions[0][3] = positions[1][3] = 0;            // neither end moves
    positions[4].head<3>() = positions[5].head<3>();  // no length, no direction
    for (std::uint32_t count = 0; count <= springs; ++count) {
        std::vector<Slot> plain = positions, fast = positions;
        plain_spring_kernels().project({level.data(), count}, plain.data(), idle);
        spring_kernels().project({level.data(), count}, fast.data(), idle);
        EXPECT_EQ(plain, fast) << count << " springs";
    }
}

TEST(SpringLayout, NoTwoSpringsOfALevelShareAVertexAndSharersKeepTheirOrder) {
    const SpringNetwork network = surface_springs(make_organ_by_formula("sphere@5mm"), {});
    const SpringLayout layout = lay_out(network, 0.01);
    ASSERT_EQ(layout.springs.size(), network.springs.size());
    // At each vertex the springs, in the order of their levels, are those of the network in its order.
    std::vector<std::vector<std::pair<std::uint32_t, Index>>> laid_out(network.rest.size());
    for (const auto& spring : layout.springs) {
        const Index a = layout.vertex_of[spring.a], b = layout.vertex_of[spring.b];
        laid_out[a].emplace_back(spring.level, b);
        laid_out[b].emplace_back(spring.level, a);
    }
    std::vector<std::vector<Index>> expected(network.rest.size());
    for (const auto& spring : network.springs) {
        expected[spring.a].push_back(spring.b);
        expected[spring.b].push_back(spring.a);
    }
    for (std::size_t v = 0; v < laid_out.size(); ++v) {
        std::ranges::sort(laid_out[v]);
        std::vector<Index> others;
        for (const auto& [level, other] : laid_out[v]) others.push_back(other);
        EXPECT_EQ(others, expected[v]) << "vertex " << v;
        const auto twice = std::ranges::adjacent_find(
            laid_out[v], [](const auto& a, const auto& b) { return a.first == b.first; });
        EXPECT_EQ(twice, laid_out[v].end()) << "two springs of a level at vertex " << v;
    }
}

TEST(SpringLayout, RefusesAVertexInTwoPatches) {
    SpringNetwork network = surface_springs(make_organ_by_formula("sphere@20mm"), {});
    network.patches = {{1, 2}, {2, 3}};
    EXPECT_THROW((void)lay_out(network, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace trocar
