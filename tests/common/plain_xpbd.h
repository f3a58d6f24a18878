#pragma once

#include "common/deformation/xpbd.h"

namespace trocar {

/// The integrator as its paper writes it: all vertices and all springs, one after another in the network's
/// order. What the real one is compared with.
inline void plain_step(const SpringNetwork& network, const Integration& settings, const StepLoad& load,
                       OrganState& state) {
    const std::size_t count = network.rest.size();
    const double h = settings.dt / settings.substeps, kept = 1 / (1 + settings.damping * h);
    std::vector<double> w(count);
    std::vector<bool> held(count, false);
    for (const Index v : load.kinematic) held[v] = true;
    for (std::size_t v = 0; v < count; ++v) {
        w[v] = network.fixed[v] || held[v] ? 0 : 1 / (network.masses[v] * (1 + settings.damping * h));
        if (held[v] || network.fixed[v]) state.velocities[v] = Vec3::Zero();
        if (network.fixed[v] && !held[v]) state.positions[v] = network.rest[v];
    }
    std::vector<Vec3> accelerations(count, Vec3::Zero());
    for (const VertexForce& f : load.forces) accelerations[f.vertex] = f.force * w[f.vertex];
    for (int k = 0; k < settings.substeps; ++k) {
        const std::vector<Vec3> before = state.positions;
        for (std::size_t v = 0; v < count; ++v) {
            state.positions[v] += h * (kept * state.velocities[v] + h * accelerations[v]);
        }
        for (const auto& [a, b, rest_length, stiffness] : network.springs) {
            const Vec3 along = state.positions[b] - state.positions[a];
            const double length = along.norm(), compliance = 1 / (stiffness * h * h);
            if (w[a] + w[b] == 0 || length == 0) continue;
            const Vec3 pull = along * ((length - rest_length) / (length * (w[a] + w[b] + compliance)));
            state.positions[a] += w[a] * pull;
            state.positions[b] -= w[b] * pull;
        }
        for (std::size_t v = 0; v < count; ++v) {
            const double stiffness = network.rest_stiffness[v];
            if (w[v] == 0 || stiffness == 0) continue;
            state.positions[v] +=
                (network.rest[v] - state.positions[v]) * (w[v] / (w[v] + 1 / (stiffness * h * h)));
        }
        for (const auto& [v, point, normal] : load.half_spaces) {
            const double above = normal.dot(state.positions[v] - point);
            if (w[v] != 0 && above < 0) state.positions[v] -= above * normal;
        }
        for (std::size_t v = 0; v < count; ++v) {
            state.velocities[v] = (state.positions[v] - before[v]) / h;
        }
    }
}

}  // namespace trocar
