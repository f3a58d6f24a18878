#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/deformation/xpbd.h"
#include "common/geometry/organ_shapes.h"

namespace trocar {
namespace {

constexpr double dt = 1.0 / 30;

/// Masses in a row along −z, one spring after another; the first is fixed.
SpringNetwork chain(int links, double link_length, double stiffness, double mass) {
    SpringNetwork network;
    for (int k = 0; k <= links; ++k) {
        network.rest.emplace_back(0, 0, -k * link_length);
        network.masses.push_back(mass);
        network.rest_stiffness.push_back(0);
        network.fixed.push_back(k == 0);
        if (k > 0) network.springs.push_back({k - 1, k, link_length, stiffness});
    }
    return network;
}

OrganState at_rest(const SpringNetwork& network) {
    return {network.rest, std::vector<Vec3>(network.rest.size(), Vec3::Zero())};
}

XpbdIntegrator integrator_at_rest(const SpringNetwork& network, double damping, int substeps) {
    return {network, at_rest(network), {.dt = dt, .damping = damping, .substeps = substeps}};
}

void settle(XpbdIntegrator& integrator, const StepLoad& load, double seconds) {
    for (int k = 0; k < static_cast<int>(seconds / dt); ++k) integrator.step(load);
}

/// Stiffness of a chain's springs, g/s²: seven decades.
class OneSpring : public testing::TestWithParam<double> {};

TEST_P(OneSpring, StretchesByHookesLaw) {
    const double stiffness = GetParam(), stretch = 2.5;
    XpbdIntegrator integrator = integrator_at_rest(chain(1, 10, stiffness, 1), 5, 20);
    const std::vector<VertexForce> load = {{1, Vec3(0, 0, -stiffness * stretch)}};
    settle(integrator, {.kinematic = {}, .forces = load, .half_spaces = {}}, 120);
    EXPECT_NEAR(integrator.state().positions[1].z(), -10 - stretch, 1e-3 * stretch);
    EXPECT_NEAR(integrator.state().velocities[1].norm(), 0, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(StiffnessOverSevenDecades, OneSpring,
                         testing::Values(1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8));

TEST(HangingChain, StretchesEachLinkByTheWeightBelowIt) {
    const int links = 8;
    const double length = 5, stiffness = 4e4, mass = 0.5, gravity = 9810;  // mm/s²
    // One iteration a substep leaves each link (links below it) · g h² too long, h the substep: hence many.
    XpbdIntegrator integrator = integrator_at_rest(chain(links, length, stiffness, mass), 5, 200);
    std::vector<VertexForce> weights;
    for (Index k = 1; k <= links; ++k) weights.push_back({k, Vec3(0, 0, -mass * gravity)});
    settle(integrator, {.kinematic = {}, .forces = weights, .half_spaces = {}}, 60);
    for (int k = 1; k <= links; ++k) {
        const double stretch =
            (integrator.state().positions[k] - integrator.state().positions[k - 1]).norm() - length;
        const double expected = (links - k + 1) * mass * gravity / stiffness;
        EXPECT_NEAR(stretch, expected, 0.01 * expected) << "link " << k;
    }
}

TEST(SpringToRest, HoldsAForceByHookesLaw) {
    const Organ sheet = make_organ_by_formula("sheet@10mm");
    const SpringSettings settings{.edge_stiffness = 1e-6};  // only the springs to rest act
    XpbdIntegrator integrator =
        integrator_at_rest(surface_springs(sheet, settings), settings.damping, settings.substeps);
    Index inner = 0;
    while (sheet.adjacency.on_boundary(inner)) ++inner;
    const double stretch = 0.7;
    const std::vector<VertexForce> load = {
        {inner, Vec3(0, 0, stretch * integrator.network().rest_stiffness[inner])}};
    settle(integrator, {.kinematic = {}, .forces = load, .half_spaces = {}}, 5);
    EXPECT_NEAR(integrator.state().positions[inner].z(), stretch, 1e-6);
}

TEST(SurfaceSprings, SharesOutTheWholeMassByArea) {
    const Organ sheet = make_organ_by_formula("sheet@6mm");
    const SpringNetwork network = surface_springs(sheet, {.density = 3e-3});
    double mass = 0;
    for (const double m : network.masses) mass += m;
    EXPECT_NEAR(mass, 3e-3 * 120 * 120, 1e-9);
}

TEST(SurfaceSprings, FixesTheBoundaryOfAnOpenSheetOnly) {
    const Organ sheet = make_organ_by_formula("sheet@6mm");
    const SpringNetwork network = surface_springs(sheet, {});
    for (std::size_t v = 0; v < network.rest.size(); ++v) {
        const Vec3& p = network.rest[v];
        const bool border = std::max(std::abs(p.x()), std::abs(p.y())) > 59.999;
        EXPECT_EQ(network.fixed[v], border) << "vertex " << v;
    }
}

TEST(SurfaceSprings, RefusesAMaterialThatIsNone) {
    const Organ sheet = make_organ_by_formula("sheet@20mm");
    EXPECT_THROW(surface_springs(sheet, {.density = 0}), std::invalid_argument);
    EXPECT_THROW(surface_springs(sheet, {.edge_stiffness = -1}), std::invalid_argument);
    EXPECT_THROW(surface_springs(sheet, {.rest_stiffness = std::nan("")}), std::invalid_argument);
    EXPECT_THROW(integrator_at_rest(surface_springs(sheet, {}), -1, 10), std::invalid_argument);
    EXPECT_THROW(integrator_at_rest(surface_springs(sheet, {}), 0, 0), std::invalid_argument);
    EXPECT_THROW(XpbdIntegrator(surface_springs(sheet, {}), OrganState{}, {}), std::invalid_argument);
}

struct Material {
    double edge_stiffness, rest_stiffness, damping;
};

class Surface : public testing::TestWithParam<Material> {
  protected:
    const Organ organ_ = make_organ_by_formula("sphere@8mm");
    const SpringSettings settings_{.edge_stiffness = GetParam().edge_stiffness,
                                   .rest_stiffness = GetParam().rest_stiffness,
                                   .damping = GetParam().damping};
    XpbdIntegrator integrator_ =
        integrator_at_rest(surface_springs(organ_, settings_), settings_.damping, settings_.substeps);

    /// Pushes a smooth dent of `depth` mm into the sphere.
    void dent(double depth) {
        for (std::size_t v = 0; v < organ_.rest.positions.size(); ++v) {
            Vec3 p = organ_.rest.positions[v];
            const double beside = p.head<2>().norm();
            if (p.z() <= 0 || beside >= 20) continue;
            p.z() -= depth * (1 + std::cos(std::numbers::pi * beside / 20)) / 2;
            integrator_.put(static_cast<Index>(v), p);
        }
    }
};

TEST_P(Surface, GainsNoEnergyWithoutContact) {
    dent(10);
    const double start = integrator_.energy();
    double before = start;
    for (int k = 0; k < 60; ++k) {
        integrator_.step();
        const double after = integrator_.energy();
        // Near rest the energy is rounding noise.
        ASSERT_LE(after, before * (1 + 1e-9) + 1e-18 * start) << "step " << k;
        before = after;
    }
}

TEST_P(Surface, GoesBackToRest) {
    dent(10);
    const double start = integrator_.energy();
    settle(integrator_, {}, 20);
    EXPECT_LT(integrator_.energy(), 1e-6 * start);
}

TEST_P(Surface, StaysFiniteWhenVerticesAreDraggedAt2000mmPerSecond) {
    std::vector<Index> dragged;
    for (Index v = 0; v < static_cast<Index>(organ_.rest.positions.size()); ++v) {
        if (organ_.rest.positions[v].z() > 35) dragged.push_back(v);
    }
    ASSERT_GT(dragged.size(), 3U);
    for (int k = 0; k < 30; ++k) {
        const double sign = k / 2 % 2 == 0 ? 1 : -1;
        for (const Index v : dragged) {
            integrator_.put(v, integrator_.state().positions[v] + Vec3(sign * 2000 * dt, 0, 0));
        }
        integrator_.step({.kinematic = dragged, .forces = {}, .half_spaces = {}});
    }
    for (const Vec3& p : integrator_.state().positions) {
        ASSERT_TRUE(p.allFinite());
        ASSERT_LT(p.norm(), 1000);
    }
    settle(integrator_, {}, 20);
    for (std::size_t v = 0; v < organ_.rest.positions.size(); ++v) {
        ASSERT_LT((integrator_.state().positions[v] - organ_.rest.positions[v]).norm(), 0.1);
    }
}

INSTANTIATE_TEST_SUITE_P(StiffnessOverSevenDecades, Surface,
                         testing::Values(Material{2e4, 100, 4000}, Material{2e4, 500, 20},
                                         Material{2e1, 5e-1, 20}, Material{2e2, 5e0, 20},
                                         Material{2e3, 5e1, 20}, Material{2e5, 5e3, 20},
                                         Material{2e6, 5e4, 20}, Material{2e7, 5e5, 20},
                                         Material{2e8, 5e6, 20}, Material{2e4, 500, 1}),
                         [](const testing::TestParamInfo<Material>& the) {
                             return "edge_1e" +
                                    std::to_string(std::lround(std::log10(the.param.edge_stiffness))) +
                                    "_damping_" + std::to_string(std::lround(the.param.damping));
                         });

TEST(Kinematic, VerticesStayWhereTheyArePut) {
    const Organ organ = make_organ_by_formula("sphere@10mm");
    XpbdIntegrator integrator = integrator_at_rest(surface_springs(organ, {}), 20, 10);
    const std::vector<Index> held = {3, 8};
    const Vec3 put = organ.rest.positions[3] + Vec3(1, 2, 3);
    integrator.put(3, put);
    const Vec3 other = integrator.state().positions[8];
    settle(integrator, {.kinematic = held, .forces = {}, .half_spaces = {}}, 1);
    EXPECT_EQ(integrator.state().positions[3], put);
    EXPECT_EQ(integrator.state().positions[8], other);
    EXPECT_EQ(integrator.state().velocities[3], Vec3(0, 0, 0));
    const Index neighbour = organ.adjacency.neighbours(3)[0];
    EXPECT_GT((integrator.state().positions[neighbour] - organ.rest.positions[neighbour]).norm(), 0.1)
        << "it is pulled along";
}

TEST(Kinematic, AFixedVertexGoesBackWhenItIsLetGo) {
    const Organ sheet = make_organ_by_formula("sheet@20mm");
    XpbdIntegrator integrator = integrator_at_rest(surface_springs(sheet, {}), 20, 10);
    ASSERT_TRUE(sheet.adjacency.on_boundary(0));
    integrator.put(0, sheet.rest.positions[0] + Vec3(0, 0, 5));
    const std::vector<Index> held = {0};
    integrator.step({.kinematic = held, .forces = {}, .half_spaces = {}});
    EXPECT_DOUBLE_EQ(integrator.state().positions[0].z(), 5);
    integrator.step();
    EXPECT_EQ(integrator.state().positions[0], sheet.rest.positions[0]);
}

TEST(HalfSpace, KeepsAVertexOutAndLetsItLeave) {
    const Organ organ = make_organ_by_formula("sphere@10mm");
    XpbdIntegrator integrator = integrator_at_rest(surface_springs(organ, {}), 20, 10);
    const Vec3 rest = organ.rest.positions[0], outwards = rest.normalized();
    // A plane 2 mm outside the vertex's rest place: the springs pull it back against the plane.
    const std::vector<HalfSpace> plane = {{0, rest + 2 * outwards, outwards}};
    settle(integrator, {.kinematic = {}, .forces = {}, .half_spaces = plane}, 1);
    EXPECT_NEAR(outwards.dot(integrator.state().positions[0] - rest), 2, 1e-9);
    // One 2 mm inside does nothing.
    const std::vector<HalfSpace> below = {{0, rest - 2 * outwards, outwards}};
    settle(integrator, {.kinematic = {}, .forces = {}, .half_spaces = below}, 10);
    EXPECT_NEAR((integrator.state().positions[0] - rest).norm(), 0, 1e-6);
}

}  // namespace
}  // namespace trocar
