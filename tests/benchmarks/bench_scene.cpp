#include "tests/benchmarks/bench_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"

namespace trocar {

Organ sphere_of(int facets, double edge) {
    const auto& shapes = all_organ_shapes();
    const auto sphere = std::ranges::find(shapes, "sphere", &OrganShape::name);
    // That many equilateral facets cover a sphere of this diameter.
    const double size = edge * std::sqrt(facets * std::numbers::sqrt3 / 4 / std::numbers::pi);
    return sphere->make(fmt::format("sphere of {} facets", facets), edge, size);
}

BenchScene::BenchScene(Organ the_organ, Tool the_tool, const std::string& scene_name, double speed)
    : organ(std::move(the_organ)),
      queries(organ.rest),
      tool(std::move(the_tool)),
      scene(prepare_scene(find_scene(scene_name), {.organ = organ,
                                                   .organ_queries = queries,
                                                   .tool = tool,
                                                   .speed = speed,
                                                   .dt = CycleSettings{}.dt(),
                                                   .seed = 1})) {}

const BenchScene& scene_on(const BenchOrgan& organ, const std::string& scene_name) {
    static std::string kept_name;
    static std::unique_ptr<const BenchScene> kept;
    const std::string_view organ_name = organ.name;
    const std::string name = fmt::format("{}/{}", scene_name, organ_name);
    if (name != kept_name) {
        constexpr double edge = 2, speed = 100;  // mm, mm/s
        kept.reset();
        Organ made = organ_name.starts_with("liver") ? make_organ_by_formula(organ_name)
                                                     : sphere_of(organ.facets, edge);
        kept = std::make_unique<const BenchScene>(std::move(made), make_tool_by_formula("prism-12"),
                                                  scene_name, speed);
        kept_name = name;
    }
    return *kept;
}

std::size_t steps_that_count(const PreparedScene& scene) {
    const auto last = std::find(scene.window.rbegin(), scene.window.rend(), true);
    return static_cast<std::size_t>(scene.window.rend() - last);
}

void run_scene(Cycle& cycle, const PreparedScene& scene, Strategy& strategy, const Onlookers& onlookers) {
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy.handle(contact, response);
    };
    for (std::size_t step = 0; step < steps_that_count(scene); ++step) {
        cycle.move(scene.poses[step]);
        cycle.detect();
        if (scene.window[step]) onlookers.detected(cycle);
        cycle.handle(handler);
        cycle.deform();
        if (scene.window[step]) onlookers.ended(cycle);
    }
}

bool tool_moved(const Cycle& cycle) {
    const Pose &before = cycle.motion().before(), &after = cycle.motion().after();
    return before.position != after.position || before.rotation != after.rotation;
}

double percentile(std::vector<double> samples, double share) {
    if (samples.empty()) throw std::invalid_argument("no samples");
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(samples.size()))) - 1;
    const auto at = samples.begin() + std::max<std::ptrdiff_t>(rank, 0);
    std::ranges::nth_element(samples, at);
    return *at;
}

double mean(const std::vector<double>& samples) {
    return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

}  // namespace trocar
