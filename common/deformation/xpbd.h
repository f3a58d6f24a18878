#pragma once

#include <span>
#include <vector>

#include "common/deformation/awake_patches.h"
#include "common/deformation/constraints.h"
#include "common/deformation/spring_kernels.h"
#include "common/deformation/spring_layout.h"
#include "common/deformation/spring_network.h"

namespace trocar {

/// What of an organ changes from step to step.
struct OrganState {
    std::vector<Vec3> positions;   ///< mm
    std::vector<Vec3> velocities;  ///< mm/s
};

/// What a step does to the organ from outside.
struct StepLoad {
    std::span<const Index> kinematic;  ///< vertices that stay where they are, each once
    std::span<const VertexForce> forces;
    std::span<const HalfSpace> half_spaces;
};

/// How a network is integrated.
struct Integration {
    double dt = 1.0 / 30;   ///< length of a step, s
    double damping = 4000;  ///< c: rate at which the velocity of a free mass decays, 1/s
    int substeps = 10;      ///< of each step
    /// A patch of vertices none of which would go further than this in a thirtieth of a second may fall
    /// asleep, mm; at 0 nothing ever sleeps.
    double still = 0;
};

/// Integrates a spring network by extended position-based dynamics, one iteration in each of many small
/// substeps: stable for any stiffness and step (Macklin et al., "Small Steps in Physics Simulation", 2019,
/// algorithm 1).
///
/// **Sleep.** A patch falls asleep when it has been still for a tenth of a second and nothing acts on it. It
/// wakes when something acts on it or on a patch beside it, or when a vertex to which a spring joins it has
/// moved by more than `still` since it fell asleep, in whichever substep. What sleeps is left where it is,
/// without velocity. Where patches that sleep and patches that are awake meet, springs are all but relaxed: a
/// spring that would move a vertex by more than `still` in a substep has both its ends awake or both asleep.
/// (One iteration does not solve the springs. To rest is to be moved to and fro within a substep, and what is
/// moved alone comes to rest elsewhere.) A step costs what is awake, in the order in which it would be done
/// were all awake.
class XpbdIntegrator {
  public:
    /// Begins at `start`; what of it is at rest sleeps. Throws std::invalid_argument when a mass is not
    /// positive, the step is not, damping is negative, there is no substep, or `start` has not the network's
    /// size.
    XpbdIntegrator(SpringNetwork network, OrganState start, const Integration& settings);
    XpbdIntegrator(const XpbdIntegrator&) = delete;
    XpbdIntegrator& operator=(const XpbdIntegrator&) = delete;

    /// Puts a vertex there (mm), between steps.
    void put(Index vertex, const Vec3& position);

    /// Advances the network by a step.
    void step(const StepLoad& load = {});

    /// As it is now.
    [[nodiscard]] const OrganState& state() const { return state_; }

    /// The patches (by their place in the network's list) with a vertex that the last step moved or that was
    /// put elsewhere since; in no order. All others are where they were.
    [[nodiscard]] std::span<const std::uint32_t> moved_patches() const { return moved_; }

    /// Share of the vertices that are awake, in [0, 1].
    [[nodiscard]] double awake_share() const;

    /// Kinetic energy and energy stored in the springs, g·mm²/s² (= nJ).
    [[nodiscard]] double energy() const;

    [[nodiscard]] const SpringNetwork& network() const { return network_; }

  private:
    using Spring = SpringLayout::Spring;

    void check_input() const;
    void place(const OrganState& start);
    void set_free_masses();
    void set_inverse_mass(std::uint32_t slot);
    void set_inverse_masses(std::uint32_t patch);
    void hold(std::span<const Index> kinematic);
    void release(std::uint32_t slot);
    void note_moved(std::span<const std::uint32_t> patches);
    void touch(std::uint32_t patch);
    void wake_touched(const StepLoad& load);
    void wake_what_neighbours_moved();
    void wake_what_is_strained(std::span<const std::uint32_t> patches);
    std::span<const std::uint32_t> wake(std::span<const std::uint32_t> patches);
    void begin_wishes();
    void want_awake(std::uint32_t patch);
    [[nodiscard]] bool all_awake(std::span<const std::uint32_t> patches) const;
    [[nodiscard]] bool held(std::uint32_t slot) const { return held_in_[slot] == step_; }
    [[nodiscard]] bool strained(const Spring& spring, std::uint32_t slot) const;
    [[nodiscard]] std::uint32_t steps_to_sleep() const;
    [[nodiscard]] bool may_sleep(std::uint32_t patch) const;
    [[nodiscard]] bool strained_towards_awake(std::uint32_t patch) const;
    [[nodiscard]] bool neighbours_moved(std::uint32_t patch) const;
    void predict();
    void push(std::span<const VertexForce> forces);
    void project_springs();
    void pull_to_rest();
    void keep_out(std::span<const HalfSpace> half_spaces);
    void write_back();
    void let_sleep();
    void fall_asleep(std::uint32_t patch);

    SpringNetwork network_;
    Integration settings_;
    const SpringKernels& kernels_ = spring_kernels();
    double h_;  // length of a substep, s
    SpringLayout layout_;
    AwakePatches awake_;
    OrganState state_;

    // Of each slot:
    std::vector<Slot>
        positions_;  // and of one more, idle: mm; the inverse mass, 0 for what is fixed, held or asleep, 1/g
    std::vector<Slot> before_;            // at the start of the substep, likewise
    std::vector<Slot> rest_;              // mm, and the inverse mass again
    std::vector<Slot> velocities_;        // mm/s, and 0
    std::vector<double> rest_shares_;     // of the way to its rest place that a free vertex is pulled
    std::vector<std::uint64_t> held_in_;  // the last step in which it was kinematic
    std::vector<double> free_masses_;     // inverse masses when awake and not held, 1/g
    // Of each patch:
    std::vector<double> speeds_;             // the largest of a vertex in this step, squared, mm²/s²
    std::vector<std::uint32_t> calm_steps_;  // for how many steps it has been still
    std::vector<std::uint64_t> touched_in_, moved_in_, looked_at_in_, wished_in_;
    std::vector<Vec3> anchors_;  // where the outer slots of a patch were when it fell asleep

    std::vector<std::uint32_t> held_, moved_;
    std::vector<std::uint32_t> touched_, sleepy_, to_wake_;  // scratch
    std::uint64_t step_ = 1, look_ = 0;
};

}  // namespace trocar
