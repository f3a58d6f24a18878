#include "common/cycle/cycle.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "common/cycle/check_response.h"

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
      integrator_(surface_springs(organ, springs), springs.damping, springs.substeps),
      organ_(organ),
      state_(std::move(start.organ)),
      tool_(tool, start.tool),
      motion_(start.tool, start.tool),
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
        detector_.detect(state_.positions, tool_.tool(), motion_, detected_);
        release_held();
    });
}

void Cycle::release_held() {
    if (settings_.release == Release::step) {
        held_.clear();
        return;
    }
    std::erase_if(held_, [&](Index vertex) {
        return !tool_.within(state_.positions[vertex], 2 * settings_.clearance);
    });
}

Contact Cycle::contact() const {
    return {.organ = organ_,
            .positions = state_.positions,
            .velocities = state_.velocities,
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
    check_response(response_, state_.positions.size());
    apply_response();
}

void Cycle::apply_response() {
    for (const auto& [vertex, displacement] : response_.displacements) {
        state_.positions[vertex] += displacement;
        held_.push_back(vertex);
    }
    std::ranges::sort(held_);
    const auto repeated = std::ranges::unique(held_);
    held_.erase(repeated.begin(), repeated.end());
}

void Cycle::deform() {
    times_.deform = timed([&] {
        integrator_.step(
            state_, settings_.dt(),
            {.kinematic = held_, .forces = response_.forces, .half_spaces = response_.half_spaces});
    });
}

}  // namespace trocar
