#include "experiments/cli/bench_run.h"

#include <algorithm>
#include <utility>

#include "strategies/registry.h"

namespace trocar {
namespace {

BenchTimes run(const Organ& organ, const Tool& tool, const PreparedScene& scene, const std::string& name) {
    const auto strategy = make_strategy(name);
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy->handle(contact, response);
    };
    Cycle cycle(organ, tool, scene.start, CycleSettings{}, SpringSettings{});
    BenchTimes times;
    for (std::size_t step = 0; step < scene.poses.size(); ++step) {
        cycle.move(scene.poses[step]);
        cycle.detect();
        cycle.handle(handler);
        cycle.deform();
        if (!scene.window[step]) continue;
        times.steps.push_back(cycle.times());
        times.collided.push_back(cycle.detected().collided.size());
    }
    return times;
}

}  // namespace

BenchScenes bench_scenes(const Organ& organ, const Tool& tool, std::size_t least_steps) {
    const SurfaceQueries queries(organ.rest);
    BenchScenes scenes;
    for (std::uint64_t seed = 1; scenes.steps < least_steps; ++seed) {
        PreparedScene scene = prepare_scene(find_scene("penetration"), {.organ = organ,
                                                                        .organ_queries = queries,
                                                                        .tool = tool,
                                                                        .speed = bench_speed,
                                                                        .dt = CycleSettings{}.dt(),
                                                                        .seed = seed});
        const auto counted = static_cast<std::size_t>(std::ranges::count(scene.window, true));
        if (counted == 0)
            throw PlacementError(
                "the tool does not meet the organ; how large a mesh from a file is, in mm, says --size");
        scenes.steps += counted;
        scenes.runs.push_back(std::move(scene));
    }
    return scenes;
}

BenchTimes time_strategy(const Organ& organ, const Tool& tool, const BenchScenes& scenes,
                         const std::string& strategy) {
    run(organ, tool, scenes.runs.front(), strategy);
    BenchTimes all;
    for (const PreparedScene& scene : scenes.runs) {
        const BenchTimes one = run(organ, tool, scene, strategy);
        all.steps.insert(all.steps.end(), one.steps.begin(), one.steps.end());
        all.collided.insert(all.collided.end(), one.collided.begin(), one.collided.end());
    }
    return all;
}

}  // namespace trocar
