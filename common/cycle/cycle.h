#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/cycle/check_response.h"
#include "common/cycle/contact.h"
#include "common/deformation/xpbd.h"
#include "common/detection/detector.h"

namespace trocar {

/// How long a handled vertex stays kinematic (put, with infinite mass).
enum class Release {
    contact,  ///< in its step and for as long as it is within 2 g of the tool
    step,     ///< in its step only: the literal reading of the paper's cycle
};

/// How the cycle runs; the defaults of a sweep file's table `[cycle]`.
struct CycleSettings {
    double rate = 30;         ///< steps a second, Hz
    double clearance = 0.01;  ///< g: how far outside the tool a handled vertex is put, mm
    Release release = Release::contact;

    [[nodiscard]] double dt() const { return 1 / rate; }
};

/// Wall-clock time of each phase of one step, ns.
struct PhaseTimes {
    std::int64_t move = 0, detect = 0, handle = 0, deform = 0;
    [[nodiscard]] std::int64_t cycle() const { return move + detect + handle + deform; }
};

/// What a cycle begins from.
struct CycleStart {
    Pose tool;
    OrganState organ;
    std::vector<Index> held;  ///< vertices that the tool holds from before (see Release), ascending
};

/// The organ at rest, untouched.
CycleStart start_at_rest(const Organ& organ, const Pose& tool);

/// Whatever answers a contact: a strategy's handle(), or a test's own function.
using Handler = std::function<void(const Contact&, Response&)>;

/// The simulation cycle (the paper's Fig. 1): move ▸ detect ▸ handle ▸ deform. The phases are called in this
/// order, once each per step; each is timed, and nothing but the phase is inside its timing. Between phases
/// the caller may look at everything.
class Cycle {
  public:
    /// Organ and tool must outlive the cycle.
    Cycle(const Organ& organ, const Tool& tool, CycleStart start, const CycleSettings& cycle,
          const SpringSettings& springs);

    /// Begins a step: the tool goes to `next`.
    void move(const Pose& next);
    /// Finds what collides with the tool where it is now.
    void detect();
    /// Asks `handler` for a response to what was detected and moves the vertices that it displaces.
    /// Throws what ResponseCheck throws.
    void handle(const Handler& handler);
    /// Ends the step: the deformation moves all vertices that are not held.
    void deform();

    /// What handling is given in this step. It views the organ as it is now: between `detect` and `handle` as
    /// the step found it, afterwards as it was moved.
    [[nodiscard]] Contact contact() const;
    /// Of every organ vertex, mm; a view of the organ as it is now.
    [[nodiscard]] std::span<const Vec3> positions() const { return integrator_.state().positions; }
    /// Of every organ vertex, mm/s.
    [[nodiscard]] std::span<const Vec3> velocities() const { return integrator_.state().velocities; }
    [[nodiscard]] const PlacedTool& tool() const { return tool_; }
    [[nodiscard]] const ToolMotion& motion() const { return motion_; }
    [[nodiscard]] const Detected& detected() const { return detected_; }
    [[nodiscard]] const Response& response() const { return response_; }
    /// Vertices that are kinematic in this step because they were handled, ascending.
    [[nodiscard]] std::span<const Index> held() const { return held_; }
    /// Share of the organ's vertices that did not sleep when the last step ended, in [0, 1].
    [[nodiscard]] double awake_share() const { return integrator_.awake_share(); }
    [[nodiscard]] const PhaseTimes& times() const { return times_; }

  private:
    void release_held();
    void apply_response();

    CycleSettings settings_;
    Detector detector_;
    XpbdIntegrator integrator_;
    const Organ& organ_;
    PlacedTool tool_;
    ToolMotion motion_;
    Detected detected_;
    Response response_;
    ResponseCheck response_check_;
    std::vector<Index> held_;
    PhaseTimes times_;
};

}  // namespace trocar
