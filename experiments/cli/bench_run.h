#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/cycle/cycle.h"
#include "experiments/scenes/prepared_scene.h"

namespace trocar {

/// How fast the tool of `trocar bench` goes, mm/s.
inline constexpr double bench_speed = 100;

/// What `trocar bench` times strategies on: the scene `penetration` from some entry points.
struct BenchScenes {
    std::vector<PreparedScene> runs;
    std::size_t steps = 0;  ///< of all runs, those at which the tool meets the organ at rest: they count
};

/// Scenes of the seeds 1, 2, … until they have `least_steps` steps that count. Throws PlacementError,
/// also where the tool never meets the organ.
BenchScenes bench_scenes(const Organ& organ, const Tool& tool, std::size_t least_steps);

/// What the steps that count took, in their order.
struct BenchTimes {
    std::vector<PhaseTimes> steps;
    std::vector<std::size_t> collided;  ///< vertices
};

/// Runs the scenes with a strategy, one step after the other in this thread. The first of them is run twice;
/// its first time warms up and does not count.
BenchTimes time_strategy(const Organ& organ, const Tool& tool, const BenchScenes& scenes,
                         const std::string& strategy);

}  // namespace trocar
