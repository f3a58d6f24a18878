#include "common/deformation/xpbd.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace trocar {
namespace {

Eigen::Vector4d four(const Vec3& v, double last) { return {v.x(), v.y(), v.z(), last}; }

}  // namespace

XpbdIntegrator::XpbdIntegrator(SpringNetwork network, OrganState start, const Integration& settings)
    : network_(std::move(network)),
      settings_(settings),
      h_(settings.dt / settings.substeps),
      layout_(lay_out(network_, h_)),
      awake_(layout_),
      state_(std::move(start)),
      positions_(network_.rest.size() + 1, Slot(0, 0, 0, 0)),
      before_(network_.rest.size()),
      rest_(network_.rest.size()),
      velocities_(network_.rest.size()),
      rest_shares_(network_.rest.size()),
      held_in_(network_.rest.size(), 0),
      free_masses_(network_.rest.size()),
      speeds_(layout_.patches()),
      calm_steps_(layout_.patches(), 0),
      touched_in_(layout_.patches(), 0),
      moved_in_(layout_.patches(), 0),
      looked_at_in_(layout_.patches(), 0),
      wished_in_(layout_.patches(), 0),
      anchors_(layout_.outer.total()) {
    check_input();
    for (auto* list : {&held_, &touched_}) list->reserve(network_.rest.size());
    for (auto* list : {&moved_, &sleepy_, &to_wake_}) list->reserve(layout_.patches());
    place(state_);
    set_free_masses();
}

void XpbdIntegrator::check_input() const {
    if (!(settings_.dt > 0)) throw std::invalid_argument("the step must be positive");
    if (!(settings_.damping >= 0)) throw std::invalid_argument("damping must not be negative");
    if (settings_.substeps < 1) throw std::invalid_argument("at least one substep is needed");
    if (state_.positions.size() != network_.rest.size() || state_.velocities.size() != network_.rest.size()) {
        throw std::invalid_argument("the state is of another number of vertices than the network");
    }
    for (std::size_t vertex = 0; vertex < network_.masses.size(); ++vertex) {
        if (network_.masses[vertex] > 0) continue;
        throw std::invalid_argument("vertex " + std::to_string(vertex) +
                                    " has no mass: it is in no facet with an area");
    }
}

/// What is at rest is taken to have fallen asleep there, and everything else to have just moved.
void XpbdIntegrator::place(const OrganState& start) {
    std::vector<std::uint32_t> moving;
    for (std::uint32_t patch = 0; patch < layout_.patches(); ++patch) {
        bool at_rest = settings_.still > 0;
        for (std::uint32_t slot = layout_.patch_begins[patch]; slot < layout_.patch_begins[patch + 1];
             ++slot) {
            const Index vertex = layout_.vertex_of[slot];
            const Vec3 &position = start.positions[vertex], &velocity = start.velocities[vertex];
            positions_[slot] = before_[slot] = four(position, 0);
            rest_[slot] = four(network_.rest[vertex], 0);
            velocities_[slot] = four(velocity, 0);
            at_rest = at_rest && position == network_.rest[vertex] && velocity == Vec3::Zero();
            // What is fixed and elsewhere goes back in the first step, unless it is held there.
            if (network_.fixed[vertex]) held_.push_back(slot);
        }
        if (!at_rest) moving.push_back(patch);
        const auto outer = layout_.outer[patch];
        for (std::size_t k = 0; k < outer.size(); ++k) {
            anchors_[layout_.outer.begin(patch) + k] = network_.rest[layout_.vertex_of[outer[k]]];
        }
    }
    awake_.wake(moving);
    note_moved(moving);
}

void XpbdIntegrator::put(Index vertex, const Vec3& position) {
    const std::uint32_t slot = layout_.slot_of[vertex], patch = layout_.patch_of[slot];
    state_.positions[vertex] = position;
    positions_[slot].head<3>() = position;
    touch(patch);
    note_moved({&patch, 1});
}

void XpbdIntegrator::note_moved(std::span<const std::uint32_t> patches) {
    for (const std::uint32_t patch : patches) {
        if (moved_in_[patch] == step_) continue;
        moved_in_[patch] = step_;
        moved_.push_back(patch);
    }
}

void XpbdIntegrator::step(const StepLoad& load) {
    hold(load.kinematic);
    wake_touched(load);
    std::ranges::fill(speeds_, 0);
    for (int k = 0; k < settings_.substeps; ++k) {
        predict();
        push(load.forces);
        project_springs();
        pull_to_rest();
        keep_out(load.half_spaces);
        wake_what_neighbours_moved();
    }
    write_back();
    moved_.assign(awake_.patches().begin(), awake_.patches().end());
    let_sleep();
    ++step_;
    for (const std::uint32_t patch : moved_) moved_in_[patch] = step_;
}

void XpbdIntegrator::set_free_masses() {
    for (std::uint32_t slot = 0; slot < rest_.size(); ++slot) {
        const Index vertex = layout_.vertex_of[slot];
        const double mass = network_.masses[vertex] * (1 + settings_.damping * h_);
        free_masses_[slot] = network_.fixed[vertex] ? 0 : 1 / mass;
        set_inverse_mass(slot);
    }
}

/// Sets what depends on whether a vertex is free now: its inverse mass, and the share that its spring to rest
/// takes.
void XpbdIntegrator::set_inverse_mass(std::uint32_t slot) {
    const double w = awake_.awake(layout_.patch_of[slot]) && !held(slot) ? free_masses_[slot] : 0;
    const double stiffness = network_.rest_stiffness[layout_.vertex_of[slot]];
    positions_[slot][3] = rest_[slot][3] = w;
    rest_shares_[slot] = w == 0 || stiffness == 0 ? 0 : w / (w + 1 / (stiffness * h_ * h_));
}

void XpbdIntegrator::set_inverse_masses(std::uint32_t patch) {
    for (std::uint32_t slot = layout_.patch_begins[patch]; slot < layout_.patch_begins[patch + 1]; ++slot) {
        set_inverse_mass(slot);
    }
}

/// Makes these vertices kinematic and lets go of those that are no more.
void XpbdIntegrator::hold(std::span<const Index> kinematic) {
    for (const Index vertex : kinematic) {
        const std::uint32_t slot = layout_.slot_of[vertex];
        const bool held_before = step_ > 1 && held_in_[slot] == step_ - 1;
        held_in_[slot] = step_;
        velocities_[slot].setZero();
        state_.velocities[vertex] = Vec3::Zero();
        if (held_before) continue;
        set_inverse_mass(slot);
        touch(layout_.patch_of[slot]);
    }
    for (const std::uint32_t slot : held_) {
        if (held_in_[slot] != step_) release(slot);
    }
    held_.clear();
    for (const Index vertex : kinematic) held_.push_back(layout_.slot_of[vertex]);
}

/// What is fixed and was moved goes back when nothing holds it any more.
void XpbdIntegrator::release(std::uint32_t slot) {
    const Index vertex = layout_.vertex_of[slot];
    set_inverse_mass(slot);
    if (network_.fixed[vertex]) {
        if (state_.positions[vertex] == network_.rest[vertex] && velocities_[slot].isZero(0)) return;
        put(vertex, network_.rest[vertex]);
        velocities_[slot].setZero();
    }
    touch(layout_.patch_of[slot]);
}

void XpbdIntegrator::predict() {
    const double kept = 1 / (1 + settings_.damping * h_);
    for (const std::uint32_t patch : awake_.patches()) {
        kernels_.predict(positions_.data(), before_.data(), velocities_.data(), layout_.patch_begins[patch],
                         layout_.patch_begins[patch + 1], kept, h_);
    }
}

void XpbdIntegrator::push(std::span<const VertexForce> forces) {
    const double kept = 1 / (1 + settings_.damping * h_);
    for (const VertexForce& f : forces) {
        const std::uint32_t slot = layout_.slot_of[f.vertex];
        const Eigen::Vector4d acceleration = four(f.force * positions_[slot][3], 0);
        positions_[slot] = before_[slot] + h_ * (kept * velocities_[slot] + h_ * acceleration);
    }
}

void XpbdIntegrator::project_springs() {
    const auto idle = static_cast<std::uint32_t>(positions_.size() - 1);
    awake_.for_each_level(
        [&](std::span<const Spring> springs) { kernels_.project(springs, positions_.data(), idle); });
}

/// Ends the substep but for half-spaces: the springs to rest, and the velocities.
void XpbdIntegrator::pull_to_rest() {
    for (const std::uint32_t patch : awake_.patches()) {
        const double fastest = kernels_.pull_to_rest(
            positions_.data(), before_.data(), rest_.data(), rest_shares_.data(), velocities_.data(),
            layout_.patch_begins[patch], layout_.patch_begins[patch + 1], h_);
        speeds_[patch] = std::max(speeds_[patch], fastest);
    }
}

void XpbdIntegrator::keep_out(std::span<const HalfSpace> half_spaces) {
    for (const HalfSpace& allowed : half_spaces) {
        const std::uint32_t slot = layout_.slot_of[allowed.vertex];
        if (positions_[slot][3] == 0) continue;
        const double above = allowed.normal.dot(positions_[slot].head<3>() - allowed.point);
        if (above < 0) positions_[slot].head<3>() -= above * allowed.normal;
        velocities_[slot] = (positions_[slot] - before_[slot]) / h_;
    }
}

void XpbdIntegrator::write_back() {
    for (const std::uint32_t patch : awake_.patches()) {
        for (std::uint32_t slot = layout_.patch_begins[patch]; slot < layout_.patch_begins[patch + 1];
             ++slot) {
            const Index vertex = layout_.vertex_of[slot];
            state_.positions[vertex] = positions_[slot].head<3>();
            state_.velocities[vertex] = velocities_[slot].head<3>();
        }
    }
}

double XpbdIntegrator::energy() const {
    double twice = 0;
    for (std::size_t vertex = 0; vertex < network_.rest.size(); ++vertex) {
        twice += network_.masses[vertex] * state_.velocities[vertex].squaredNorm();
        twice += network_.rest_stiffness[vertex] *
                 (state_.positions[vertex] - network_.rest[vertex]).squaredNorm();
    }
    for (const SpringNetwork::Spring& spring : network_.springs) {
        const double stretch =
            (state_.positions[spring.b] - state_.positions[spring.a]).norm() - spring.rest_length;
        twice += spring.stiffness * stretch * stretch;
    }
    return twice / 2;
}

}  // namespace trocar
