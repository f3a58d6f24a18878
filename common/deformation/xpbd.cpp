#include "common/deformation/xpbd.h"

#include <stdexcept>
#include <utility>

namespace trocar {

XpbdIntegrator::XpbdIntegrator(SpringNetwork network, double damping, int substeps)
    : network_(std::move(network)),
      damping_(damping),
      substeps_(substeps),
      inverse_masses_(network_.rest.size()),
      accelerations_(network_.rest.size(), Vec3::Zero()),
      before_(network_.rest.size()) {
    if (!(damping >= 0)) throw std::invalid_argument("damping must not be negative");
    if (substeps < 1) throw std::invalid_argument("at least one substep is needed");
    for (std::size_t vertex = 0; vertex < network_.masses.size(); ++vertex) {
        if (network_.masses[vertex] > 0) continue;
        throw std::invalid_argument("vertex " + std::to_string(vertex) +
                                    " has no mass: it is in no facet with an area");
    }
}

void XpbdIntegrator::step(OrganState& state, double dt, const StepLoad& load) {
    const double h = dt / substeps_;
    set_inverse_masses(state, load.kinematic, h);
    for (const VertexForce& f : load.forces) {
        accelerations_[f.vertex] = f.force * inverse_masses_[f.vertex];
    }
    for (int k = 0; k < substeps_; ++k) {
        predict(state, h);
        project_springs(state.positions, h);
        project_to_rest(state.positions, h);
        project_half_spaces(state.positions, load.half_spaces);
        for (std::size_t vertex = 0; vertex < state.positions.size(); ++vertex) {
            state.velocities[vertex] = (state.positions[vertex] - before_[vertex]) / h;
        }
    }
    for (const VertexForce& f : load.forces) accelerations_[f.vertex] = Vec3::Zero();
}

void XpbdIntegrator::set_inverse_masses(OrganState& state, std::span<const Index> kinematic, double h) {
    for (std::size_t vertex = 0; vertex < inverse_masses_.size(); ++vertex) {
        inverse_masses_[vertex] = 1 / (network_.masses[vertex] * (1 + damping_ * h));
        if (network_.fixed[vertex]) inverse_masses_[vertex] = 0;
    }
    at_rest_.assign(network_.fixed.begin(), network_.fixed.end());
    for (const Index vertex : kinematic) {
        inverse_masses_[vertex] = 0;
        at_rest_[vertex] = false;
        state.velocities[vertex] = Vec3::Zero();
    }
    // What is fixed and was moved goes back when nothing holds it any more.
    for (std::size_t vertex = 0; vertex < at_rest_.size(); ++vertex) {
        if (!at_rest_[vertex]) continue;
        state.positions[vertex] = network_.rest[vertex];
        state.velocities[vertex] = Vec3::Zero();
    }
}

void XpbdIntegrator::predict(OrganState& state, double h) {
    const double kept = 1 / (1 + damping_ * h);
    before_ = state.positions;
    for (std::size_t vertex = 0; vertex < state.positions.size(); ++vertex) {
        state.positions[vertex] += h * (kept * state.velocities[vertex] + h * accelerations_[vertex]);
    }
}

void XpbdIntegrator::project_springs(std::vector<Vec3>& positions, double h) const {
    for (const SpringNetwork::Spring& spring : network_.springs) {
        const double w_a = inverse_masses_[spring.a], w_b = inverse_masses_[spring.b];
        const Vec3 along = positions[spring.b] - positions[spring.a];
        const double length = along.norm();
        if (w_a + w_b == 0 || length == 0) continue;
        const double compliance = 1 / (spring.stiffness * h * h);
        const Vec3 pull = along * ((length - spring.rest_length) / (length * (w_a + w_b + compliance)));
        positions[spring.a] += w_a * pull;
        positions[spring.b] -= w_b * pull;
    }
}

void XpbdIntegrator::project_to_rest(std::vector<Vec3>& positions, double h) const {
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        const double w = inverse_masses_[vertex], stiffness = network_.rest_stiffness[vertex];
        if (w == 0 || stiffness == 0) continue;
        positions[vertex] +=
            (network_.rest[vertex] - positions[vertex]) * (w / (w + 1 / (stiffness * h * h)));
    }
}

void XpbdIntegrator::project_half_spaces(std::vector<Vec3>& positions,
                                         std::span<const HalfSpace> half_spaces) const {
    for (const HalfSpace& allowed : half_spaces) {
        if (inverse_masses_[allowed.vertex] == 0) continue;
        const double above = allowed.normal.dot(positions[allowed.vertex] - allowed.point);
        if (above < 0) positions[allowed.vertex] -= above * allowed.normal;
    }
}

double XpbdIntegrator::energy(const OrganState& state) const {
    double twice = 0;
    for (std::size_t vertex = 0; vertex < state.positions.size(); ++vertex) {
        twice += network_.masses[vertex] * state.velocities[vertex].squaredNorm();
        twice +=
            network_.rest_stiffness[vertex] * (state.positions[vertex] - network_.rest[vertex]).squaredNorm();
    }
    for (const SpringNetwork::Spring& spring : network_.springs) {
        const double stretch =
            (state.positions[spring.b] - state.positions[spring.a]).norm() - spring.rest_length;
        twice += spring.stiffness * stretch * stretch;
    }
    return twice / 2;
}

}  // namespace trocar
