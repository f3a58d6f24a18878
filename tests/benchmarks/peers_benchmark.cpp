// Trocar beside other libraries, in turn in one run: Bullet's soft body, FCL with the organ as one model,
// CGAL's test of inside. See README.md.

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "common/cycle/cycle.h"
#include "strategies/registry.h"
#include "tests/benchmarks/bench_main.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/bench_tools.h"
#include "tests/benchmarks/bullet_peer.h"
#include "tests/benchmarks/cgal_peer.h"
#include "tests/benchmarks/fcl_peer.h"

namespace trocar {
namespace {

constexpr double s = 1e-9;  // of a nanosecond

/// Contacts that differ by more than this factor are not the same work.
constexpr double comparable = 2;

/// Of each step that counts: its time in ns, how many vertices were in contact; over all: the dent in mm.
struct Samples {
    std::vector<double> times, contacts;
    std::vector<double> tool_moves;  // times of the steps in which the tool moves
    double dent = 0;
};

/// The material with no vertex asleep.
SpringSettings without_sleeping() {
    SpringSettings settings;
    settings.sleep = false;
    return settings;
}

double dent_of(const Cycle& cycle, const BenchScene& on) {
    double deepest = 0;
    const std::vector<Vec3>& rest = on.organ.rest.positions;
    for (std::size_t v = 0; v < rest.size(); ++v) {
        deepest = std::max(deepest, (rest[v] - cycle.positions()[v]).dot(on.scene.placement.normal));
    }
    return deepest;
}

void run_trocar(const BenchScene& on, const std::string& strategy_name, const SpringSettings& springs,
                Samples& samples) {
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, springs);
    const std::unique_ptr<Strategy> strategy = make_strategy(strategy_name);
    run_scene(cycle, on.scene, *strategy, {.ended = [&](const Cycle& at) {
                  samples.times.push_back(static_cast<double>(at.times().cycle()));
                  if (tool_moved(at)) samples.tool_moves.push_back(samples.times.back());
                  samples.contacts.push_back(static_cast<double>(at.held().size()));
                  samples.dent = std::max(samples.dent, dent_of(at, on));
              }});
}

void run_bullet(const BenchScene& on, BulletPeer::Setup setup, Samples& samples) {
    const double dt = CycleSettings{}.dt();
    const PreparedScene& scene = on.scene;
    BulletPeer bullet(on.organ, scene.placement, scene.start.tool, SpringSettings{}.substeps, setup);
    for (std::size_t step = 0; step < steps_that_count(scene); ++step) {
        const double time = bullet.step(scene.poses[step], dt);
        if (!scene.window[step]) continue;
        samples.times.push_back(time);
        samples.contacts.push_back(static_cast<double>(bullet.contacts()));
        samples.dent = std::max(samples.dent, bullet.dent());
    }
}

/// Says whether the peer found so much as Trocar that their times can be compared.
void report_contact(benchmark::State& state, double ours, double theirs) {
    const bool same = ours > 0 && theirs > 0 && std::max(ours, theirs) <= comparable * std::min(ours, theirs);
    state.counters["comparable"] = same ? 1 : 0;
    if (!same) state.SetLabel("NOT COMPARABLE: the contacts differ by more than a factor of 2");
}

/// One iteration is the scene by Bullet in each setup, by Trocar, and by Trocar with no vertex asleep, one
/// after the other. The ratios are to Bullet's cheapest.
void against_bullet(benchmark::State& state, const std::string& strategy, const BenchOrgan& organ) {
    using Setup = BulletPeer::Setup;
    const BenchScene& on = scene_on(organ, "penetration");
    Samples in_order, shuffled, fresh, trocar, awake;
    for (auto _ : state) {
        run_bullet(on, Setup::in_order, in_order);
        run_bullet(on, Setup::shuffled, shuffled);
        run_bullet(on, Setup::fresh, fresh);
        run_trocar(on, strategy, SpringSettings{}, trocar);
        run_trocar(on, strategy, without_sleeping(), awake);
        state.SetIterationTime(percentile(shuffled.times, 0.5) * s);
    }
    const auto median = [](const std::vector<double>& times) { return percentile(times, 0.5) * s; };
    const Samples& bullet = median(in_order.times) < median(shuffled.times) ? in_order : shuffled;
    state.counters["bullet_s"] = median(bullet.times);
    state.counters["bullet_in_order_s"] = median(in_order.times);
    state.counters["bullet_shuffled_s"] = median(shuffled.times);
    state.counters["bullet_fresh_s"] = median(fresh.times);
    state.counters["trocar_s"] = median(trocar.times);
    state.counters["awake_s"] = median(awake.times);
    state.counters["ratio"] = median(bullet.times) / median(trocar.times);
    state.counters["ratio_tool_moves"] = median(bullet.times) / median(trocar.tool_moves);
    state.counters["ratio_awake"] = median(bullet.times) / median(awake.times);
    state.counters["bullet_contacts"] = mean(bullet.contacts);
    state.counters["trocar_contacts"] = mean(trocar.contacts);
    state.counters["bullet_dent_mm"] = bullet.dent;
    state.counters["trocar_dent_mm"] = trocar.dent;
    state.counters["facets"] = static_cast<double>(on.organ.rest.facets.size());
    report_contact(state, mean(trocar.contacts), mean(bullet.contacts));
}

/// One iteration is the scene by Trocar alone, and once more with FCL asked of each state that Trocar was
/// asked of.
void against_fcl(benchmark::State& state, const BenchOrgan& organ) {
    const BenchScene& on = scene_on(organ, "penetration");
    FclPeer fcl(on.organ);
    std::vector<double> refit, collide, theirs, ours, found_theirs, found_ours;
    for (auto _ : state) {
        for (const bool ask_fcl : {false, true}) {
            Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
            const std::unique_ptr<Strategy> strategy = make_strategy("fuzzy-per-vertex");
            run_scene(cycle, on.scene, *strategy, {.detected = [&](const Cycle& at) {
                          if (!ask_fcl) {
                              ours.push_back(static_cast<double>(at.times().detect));
                              found_ours.push_back(static_cast<double>(at.detected().crossed.size()));
                              return;
                          }
                          const FclPeer::Found found = fcl.detect(at.positions(), at.tool().pose());
                          refit.push_back(found.refit);
                          collide.push_back(found.collide);
                          theirs.push_back(found.refit + found.collide);
                          found_theirs.push_back(static_cast<double>(found.facets));
                      }});
        }
        state.SetIterationTime(percentile(theirs, 0.5) * s);
    }
    state.counters["fcl_s"] = percentile(theirs, 0.5) * s;
    state.counters["fcl_refit_s"] = percentile(refit, 0.5) * s;
    state.counters["fcl_collide_s"] = percentile(collide, 0.5) * s;
    state.counters["trocar_s"] = percentile(ours, 0.5) * s;
    state.counters["ratio"] = percentile(theirs, 0.5) / percentile(ours, 0.5);
    state.counters["fcl_facets"] = mean(found_theirs);
    state.counters["trocar_facets"] = mean(found_ours);
    state.counters["facets"] = static_cast<double>(on.organ.rest.facets.size());
    report_contact(state, mean(found_ours), mean(found_theirs));
}

/// In the tool's frame, the vertices that detection asks about in the scene: those in the box that the tool
/// sweeps.
std::vector<Vec3> asked_points(const BenchScene& on) {
    std::vector<Vec3> points;
    Cycle cycle(on.organ, on.tool, on.scene.start, CycleSettings{}, SpringSettings{});
    const std::unique_ptr<Strategy> strategy = make_strategy("fuzzy-per-vertex");
    run_scene(cycle, on.scene, *strategy, {.detected = [&](const Cycle& at) {
                  for (const Index vertex : at.detected().near_vertices) {
                      points.push_back(judged_position(at.tool().pose(), at.positions()[vertex]));
                  }
              }});
    return points;
}

/// Asks `contains` of every point; answers how long that took, ns.
template <typename Contains>
double ask(const std::vector<Vec3>& points, std::vector<char>& answers, const Contains& contains) {
    answers.resize(points.size());
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < points.size(); ++k) answers[k] = contains(points[k]) ? 1 : 0;
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    return took.count() / static_cast<double>(points.size());
}

/// One iteration asks both about all points, one after the other.
void against_cgal(benchmark::State& state, const BenchTool& tool) {
    constexpr int facets = 8'000;
    constexpr double edge = 1, speed = 20;  // mm, mm/s: many points
    const BenchScene on(sphere_of(4 * facets, edge), tool.make(), "penetration", speed);
    const CgalPeer cgal(on.tool.mesh);
    const std::vector<Vec3> points = asked_points(on);
    std::vector<double> theirs, ours;
    std::vector<char> their_answers, our_answers;
    for (auto _ : state) {
        theirs.push_back(ask(points, their_answers, [&](const Vec3& p) { return cgal.contains(p); }));
        ours.push_back(ask(points, our_answers, [&](const Vec3& p) { return on.tool.solid.contains(p); }));
        state.SetIterationTime(theirs.back() * s);
    }
    int disagreements = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        disagreements += our_answers[k] != their_answers[k] ? 1 : 0;
    if (disagreements > 0) state.SetLabel("THE ANSWERS DIFFER");
    state.counters["cgal_s"] = percentile(theirs, 0.5) * s;
    state.counters["trocar_s"] = percentile(ours, 0.5) * s;
    state.counters["ratio"] = percentile(theirs, 0.5) / percentile(ours, 0.5);
    state.counters["points"] = static_cast<double>(points.size());
    state.counters["inside"] = static_cast<double>(std::ranges::count(our_answers, 1));
    state.counters["disagreements"] = disagreements;
    state.counters["tool_facets"] = static_cast<double>(on.tool.mesh.facets.size());
}

/// Every benchmark here times its parts itself. Each repetition has its own ratio.
void settle(benchmark::internal::Benchmark* one, int iterations, int repetitions) {
    one->UseManualTime()->Iterations(iterations)->Repetitions(repetitions)->DisplayAggregatesOnly();
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    constexpr int large = 100'000, few = 3, many = 9;
    for (const trocar::BenchOrgan& organ : trocar::bench_organs) {
        const int repetitions = organ.facets < large ? many : few;
        for (const std::string strategy : {"nearest-face", "fuzzy-per-vertex"}) {
            const std::string name = fmt::format("bullet/{}/{}", strategy, organ.name);
            trocar::settle(benchmark::RegisterBenchmark(name.c_str(), trocar::against_bullet, strategy, organ)
                               ->Unit(benchmark::kMicrosecond),
                           1, repetitions);
        }
        const std::string name = fmt::format("fcl/{}", organ.name);
        trocar::settle(benchmark::RegisterBenchmark(name.c_str(), trocar::against_fcl, organ)
                           ->Unit(benchmark::kMicrosecond),
                       1, repetitions);
    }
    for (const trocar::BenchTool& tool : trocar::bench_tools) {
        constexpr int iterations = 20;
        trocar::settle(benchmark::RegisterBenchmark(fmt::format("cgal/{}", tool.name).c_str(),
                                                    trocar::against_cgal, tool),
                       iterations, many);
    }
    return trocar::run_benchmarks(argc, argv);
}
