// When the integrator's patches wake and fall asleep.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/deformation/xpbd.h"

namespace trocar {
namespace {

// A patch may be still for a moment where it swings back: it has to be so for some time (s).
constexpr double calm_time = 0.1;
// Still is who goes no further than Integration::still in this time (s), whatever the length of a step.
constexpr double still_time = 1.0 / 30;

}  // namespace

/// Notes that something acts on a patch in this step.
void XpbdIntegrator::touch(std::uint32_t patch) {
    if (touched_in_[patch] == step_) return;
    touched_in_[patch] = step_;
    touched_.push_back(patch);
}

/// Within a substep what happens in a patch reaches into those around it: they wake with it.
void XpbdIntegrator::wake_touched(const StepLoad& load) {
    if (settings_.still == 0) {
        touched_.clear();
        return;
    }
    for (const VertexForce& f : load.forces) touch(layout_.patch_of[layout_.slot_of[f.vertex]]);
    for (const HalfSpace& allowed : load.half_spaces)
        touch(layout_.patch_of[layout_.slot_of[allowed.vertex]]);
    begin_wishes();
    for (const std::uint32_t patch : touched_) {
        want_awake(patch);
        for (const std::uint32_t next : layout_.neighbours[patch]) want_awake(next);
    }
    touched_.clear();
    wake(to_wake_);
    wake_what_is_strained(awake_.patches());
    wake_what_neighbours_moved();
    awake_.settle();
}

void XpbdIntegrator::begin_wishes() {
    ++look_;
    to_wake_.clear();
}

void XpbdIntegrator::want_awake(std::uint32_t patch) {
    if (awake_.awake(patch) || wished_in_[patch] == look_) return;
    wished_in_[patch] = look_;
    to_wake_.push_back(patch);
}

void XpbdIntegrator::wake_what_neighbours_moved() {
    if (settings_.still == 0) return;
    begin_wishes();
    for (const std::uint32_t patch : awake_.patches()) {
        for (const std::uint32_t next : layout_.neighbours[patch]) {
            if (awake_.awake(next) || looked_at_in_[next] == look_) continue;
            looked_at_in_[next] = look_;
            if (neighbours_moved(next)) want_awake(next);
        }
    }
    wake_what_is_strained(wake(to_wake_));
}

/// Wakes what strained springs join to these patches, all awake, and what they join to that, and so on.
void XpbdIntegrator::wake_what_is_strained(std::span<const std::uint32_t> patches) {
    while (!patches.empty()) {
        begin_wishes();
        for (const std::uint32_t patch : patches) {
            if (all_awake(layout_.neighbours[patch])) continue;
            for (const std::uint32_t k : layout_.springs_at[patch]) {
                const Spring& spring = layout_.springs[k];
                const std::uint32_t other = layout_.patch_of[spring.a] == patch ? spring.b : spring.a;
                if (awake_.awake(layout_.patch_of[other])) continue;
                if (strained(spring, other)) want_awake(layout_.patch_of[other]);
            }
        }
        patches = wake(to_wake_);
    }
}

bool XpbdIntegrator::all_awake(std::span<const std::uint32_t> patches) const {
    return std::ranges::all_of(patches, [&](std::uint32_t patch) { return awake_.awake(patch); });
}

/// Whether a spring would move the free vertex at this end of it by more than what counts as still.
bool XpbdIntegrator::strained(const Spring& spring, std::uint32_t slot) const {
    const double w_a = held(spring.a) ? 0 : free_masses_[spring.a];
    const double w_b = held(spring.b) ? 0 : free_masses_[spring.b];
    const double w = slot == spring.a ? w_a : w_b;
    const double length = (positions_[spring.b] - positions_[spring.a]).head<3>().norm();
    return w * std::abs(length - spring.rest_length) > settings_.still * (w_a + w_b + spring.compliance);
}

/// Whether a vertex that a spring joins to a sleeping patch is elsewhere than when it fell asleep.
bool XpbdIntegrator::neighbours_moved(std::uint32_t patch) const {
    const double still = settings_.still * settings_.still;
    const Vec3* anchor = &anchors_[layout_.outer.begin(patch)];
    for (const std::uint32_t slot : layout_.outer[patch]) {
        if (!((positions_[slot].head<3>() - *anchor++).squaredNorm() <= still)) return true;
    }
    return false;
}

/// @returns those that were asleep, until something wakes or falls asleep again
std::span<const std::uint32_t> XpbdIntegrator::wake(std::span<const std::uint32_t> patches) {
    const std::span<const std::uint32_t> woken = awake_.wake(patches);
    for (const std::uint32_t patch : woken) {
        calm_steps_[patch] = 0;
        set_inverse_masses(patch);
    }
    return woken;
}

void XpbdIntegrator::let_sleep() {
    if (settings_.still == 0) return;
    const double slow = settings_.still / still_time;
    for (const std::uint32_t patch : awake_.patches()) {
        const bool calm = touched_in_[patch] != step_ && speeds_[patch] <= slow * slow;
        calm_steps_[patch] = calm ? calm_steps_[patch] + 1 : 0;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::uint32_t patch : awake_.patches()) {
            if (!may_sleep(patch) || !strained_towards_awake(patch)) continue;
            calm_steps_[patch] = steps_to_sleep() - 1;
            changed = true;
        }
    }
    sleepy_.clear();
    std::ranges::copy_if(awake_.patches(), std::back_inserter(sleepy_),
                         [&](std::uint32_t patch) { return may_sleep(patch); });
    awake_.let_sleep(sleepy_);
    for (const std::uint32_t patch : sleepy_) fall_asleep(patch);
}

bool XpbdIntegrator::may_sleep(std::uint32_t patch) const { return calm_steps_[patch] >= steps_to_sleep(); }

std::uint32_t XpbdIntegrator::steps_to_sleep() const {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(calm_time / settings_.dt - 1e-9)));
}

/// Whether a strained spring joins a patch that may sleep to one that stays awake.
bool XpbdIntegrator::strained_towards_awake(std::uint32_t patch) const {
    const auto stays_awake = [&](std::uint32_t other) { return awake_.awake(other) && !may_sleep(other); };
    if (std::ranges::none_of(layout_.neighbours[patch], stays_awake)) return false;
    return std::ranges::any_of(layout_.springs_at[patch], [&](std::uint32_t k) {
        const Spring& spring = layout_.springs[k];
        const bool a_is_own = layout_.patch_of[spring.a] == patch;
        const std::uint32_t other = layout_.patch_of[a_is_own ? spring.b : spring.a];
        return other != patch && stays_awake(other) && strained(spring, a_is_own ? spring.a : spring.b);
    });
}

void XpbdIntegrator::fall_asleep(std::uint32_t patch) {
    set_inverse_masses(patch);
    for (std::uint32_t slot = layout_.patch_begins[patch]; slot < layout_.patch_begins[patch + 1]; ++slot) {
        velocities_[slot].setZero();
        state_.velocities[layout_.vertex_of[slot]].setZero();
    }
    const auto outer = layout_.outer[patch];
    for (std::size_t k = 0; k < outer.size(); ++k) {
        anchors_[layout_.outer.begin(patch) + k] = positions_[outer[k]].head<3>();
    }
}

double XpbdIntegrator::awake_share() const {
    std::size_t awake = 0;
    for (const std::uint32_t patch : awake_.patches()) {
        awake += layout_.patch_begins[patch + 1] - layout_.patch_begins[patch];
    }
    return static_cast<double>(awake) / static_cast<double>(rest_.size());
}

}  // namespace trocar
