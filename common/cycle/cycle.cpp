#include "common/cycle/cycle.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace trocar {
namespace {

/// Runs `phase` and returns how long it took, ns.
template <typename Phase>
std::int64_t timed(const Phase& phase) {
    const auto start = std::chrono::steady_clock::now();
    phase();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start)
        .count();
}

// Of the clearance: who moves less than that may sleep (Integration::still). What a step does then differs
// from the full simulation by less than a tenth of the clearance (tests/experiments/sleep_test.cpp).
constexpr double still = 0.02;

Integration integration(const SpringSettings& springs, const CycleSettings& cycle) {
    return {.dt = cycle.dt(),
            .damping = springs.damping,
            .substeps = springs.substeps,
            .still = springs.sleep ? still * cycle.clearance : 0};
}

}  // namespace

CycleStart start_at_rest(const Organ& organ, const Pose& tool) {
    const std::size_t vertices = organ.rest.positions.size();
    return {
        .tool = tool,
        .organ = {.positions = organ.rest.positions, .velocities = std::vector<Vec3>(vertices, Vec3::Zero())},
        .held = {}};
}

Cycle::Cycle(const Organ& organ, const Tool& tool, CycleStart start, const CycleSettings& cycle,
             const SpringSettings& springs)
    : settings_(cycle),
      detector_(organ),
      integrator_(surface_springs(organ, springs), std::move(start.organ), integration(springs, cycle)),
      organ_(organ),
      tool_(tool, start.tool),
      motion_(start.tool, start.tool),
      response_check_(organ.rest.positions.size()),
      held_(std::move(start.held)) {
    if (!(cycle.rate > 0)) throw std::invalid_argument("the rate must be positive");
    if (!(cycle.clearance > 0)) throw std::invalid_argument("the clearance must be positive");
}

void Cycle::move(const Pose& next) {
    times_.move = timed([&] {
        motion_ = ToolMotion(tool_.pose(), next);
        tool_ = PlacedTool(tool_.tool(), next);
    });
}

void Cycle::detect() {
    times_.detect = timed([&] {
        detector_.follow(integrator_.moved_patches(), positions());
        detector_.detect(positions(), tool_.tool(), motion_, detected_);
        release_held();
    });
}

void Cycle::release_held() {
    if (settings_.release == Release::step) {
        held_.clear();
        return;
    }
    std::erase_if(held_,
                  [&](Index vertex) { return !tool_.within(positions()[vertex], 2 * settings_.clearance); });
}

Contact Cycle::contact() const {
    return {.organ = organ_,
            .positions = positions(),
            .velocities = velocities(),
            .tool = tool_,
            .motion = motion_,
            .collided = detected_.collided,
            .crossed = detected_.crossed,
            .near_vertices = detected_.near_vertices,
            .near_facets = detected_.near_facets,
            .clearance = settings_.clearance,
            .dt = settings_.dt()};
}

void Cycle::handle(const Handler& handler) {
    const Contact found = contact();
    times_.handle = timed([&] {
        response_.clear();
        handler(found, response_);
    });
    response_check_.check(response_);
    apply_response();
}

void Cycle::apply_response() {
    for (const auto& [vertex, displacement] : response_.displacements) {
        integrator_.put(vertex, positions()[vertex] + displacement);
        held_.push_back(vertex);
    }
    std::ranges::sort(held_);
    const auto repeated = std::ranges::unique(held_);
    held_.erase(repeated.begin(), repeated.end());
}

void Cycle::deform() {
    times_.deform = timed([&] {
        integrator_.step(
            {.kinematic = held_, .forces = response_.forces, .half_spaces = response_.half_spaces});
    });
}

}  // namespace trocar
