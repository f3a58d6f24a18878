#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "common/cycle/cycle.h"
#include "common/geometry/organ.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool.h"
#include "experiments/scenes/prepared_scene.h"
#include "strategies/strategy.h"

namespace trocar {

/// An organ that is measured.
struct BenchOrgan {
    const char* name;
    int facets;  ///< about
};

/// Spheres of more and more facets, all with edges of 2 mm; and a liver with such edges, whose vertices lie
/// in memory as remeshing left them, not row by row.
inline constexpr std::array<BenchOrgan, 7> bench_organs = {{
    {.name = "2000", .facets = 2'000},
    {.name = "8000", .facets = 8'000},
    {.name = "30000", .facets = 30'000},
    {.name = "liver@2mm", .facets = 30'000},
    {.name = "100000", .facets = 100'000},
    {.name = "300000", .facets = 300'000},
    {.name = "1000000", .facets = 1'000'000},
}};

/// A sphere with edges of `edge` (mm) and about so many facets: the larger it is, the more facets, and where
/// the tool touches it, it is the same.
Organ sphere_of(int facets, double edge);

/// A scene on an organ, with all that it is made from.
struct BenchScene {
    BenchScene(Organ the_organ, Tool the_tool, const std::string& scene_name, double speed);
    BenchScene(const BenchScene&) = delete;
    BenchScene& operator=(const BenchScene&) = delete;
    ~BenchScene() = default;

    Organ organ;
    SurfaceQueries queries;
    Tool tool;
    PreparedScene scene;
};

/// Tool prism-12 at 100 mm/s, seed 1. The last one that was asked for is kept: benchmarks of one organ come
/// one after the other.
const BenchScene& scene_on(const BenchOrgan& organ, const std::string& scene_name);

/// How many steps there are up to the last one of the scene's window, with it.
std::size_t steps_that_count(const PreparedScene& scene);

/// What looks on while a scene runs.
using Onlooker = std::function<void(const Cycle&)>;

/// Who looks on at the steps that count, those of the scene's window.
struct Onlookers {
    Onlooker detected = [](const Cycle&) {};  ///< after detection
    Onlooker ended = [](const Cycle&) {};     ///< at the end of the step
};

/// Runs a scene up to the last step that counts, in a cycle that may have run one before.
void run_scene(Cycle& cycle, const PreparedScene& scene, Strategy& strategy, const Onlookers& onlookers);

/// Whether the tool is elsewhere, or otherwise turned, than a step before.
bool tool_moved(const Cycle& cycle);

/// The value below which that share of the samples lies, from 0 to 1: one of them, the next above.
double percentile(std::vector<double> samples, double share);

/// Mean of the samples.
double mean(const std::vector<double>& samples);

}  // namespace trocar
