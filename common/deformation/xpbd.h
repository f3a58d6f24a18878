#pragma once

#include <span>
#include <vector>

#include "common/deformation/constraints.h"
#include "common/deformation/spring_network.h"

namespace trocar {

/// What of an organ changes from step to step.
struct OrganState {
    std::vector<Vec3> positions;   ///< mm
    std::vector<Vec3> velocities;  ///< mm/s
};

/// What a step does to the organ from outside.
struct StepLoad {
    std::span<const Index> kinematic;  ///< vertices that stay where they are
    std::span<const VertexForce> forces;
    std::span<const HalfSpace> half_spaces;
};

/// Integrates a spring network by extended position-based dynamics, one iteration in each of many small
/// substeps: stable for any stiffness and step (Macklin et al., "Small Steps in Physics Simulation", 2019,
/// algorithm 1).
class XpbdIntegrator {
  public:
    /// Throws std::invalid_argument when a mass is not positive, damping is negative or there is no substep.
    /// @param damping c: rate at which the velocity of a free mass decays, 1/s
    /// @param substeps of each step
    XpbdIntegrator(SpringNetwork network, double damping, int substeps);

    /// Advances `state` by `dt` seconds.
    void step(OrganState& state, double dt, const StepLoad& load = {});

    /// Kinetic energy and energy stored in the springs, g·mm²/s² (= nJ).
    [[nodiscard]] double energy(const OrganState& state) const;

    [[nodiscard]] const SpringNetwork& network() const { return network_; }

  private:
    void set_inverse_masses(OrganState& state, std::span<const Index> kinematic, double h);
    void predict(OrganState& state, double h);
    void project_springs(std::vector<Vec3>& positions, double h) const;
    void project_to_rest(std::vector<Vec3>& positions, double h) const;
    void project_half_spaces(std::vector<Vec3>& positions, std::span<const HalfSpace> half_spaces) const;

    SpringNetwork network_;
    double damping_;
    int substeps_;
    std::vector<double> inverse_masses_;  // of the damped masses, 1/g; zero for what is fixed or kinematic
    std::vector<bool> at_rest_;           // fixed vertices that nothing holds elsewhere in this step
    std::vector<Vec3> accelerations_;     // by this step's forces, mm/s²
    std::vector<Vec3> before_;            // positions at the start of the substep
};

}  // namespace trocar
