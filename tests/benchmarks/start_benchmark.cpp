// How long it takes, and how much memory, from an OFF file of a million facets to the first step. See
// README.md.

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/cycle/cycle.h"
#include "common/geometry/mesh_input.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/prepared_scene.h"
#include "tests/benchmarks/bench_main.h"
#include "tests/benchmarks/bench_scene.h"

namespace trocar {
namespace {

/// What a child tells of its start, s. The parts follow each other.
struct Start {
    double organ;  ///< read, checked, made
    double scene;  ///< placed on it and laid out
    double cycle;  ///< made
};

class Stopwatch {
  public:
    /// Since it was made or asked, s.
    double lap() {
        const auto before = std::exchange(since_, Clock::now());
        return std::chrono::duration<double>(since_ - before).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point since_ = Clock::now();
};

void write_off(const std::filesystem::path& file, int facets) {
    constexpr double edge = 2;  // mm
    const Organ organ = sphere_of(facets, edge);
    std::ofstream stream(file);
    stream.precision(std::numeric_limits<double>::max_digits10);
    stream << "OFF\n" << organ.rest.positions.size() << ' ' << organ.rest.facets.size() << " 0\n";
    for (const Vec3& p : organ.rest.positions) stream << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& [a, b, c] : organ.rest.facets) stream << "3 " << a << ' ' << b << ' ' << c << '\n';
    if (!stream.flush()) throw std::runtime_error("cannot write the mesh");
}

Start start_from(const std::filesystem::path& file) {
    Stopwatch watch;
    Start start{};
    const Organ organ = read_organ(file).organ;
    start.organ = watch.lap();
    const Tool tool = make_tool_by_formula("prism-12");
    const SurfaceQueries queries(organ.rest);
    constexpr double speed = 100;  // mm/s
    const PreparedScene scene = prepare_scene(find_scene("penetration"), {.organ = organ,
                                                                          .organ_queries = queries,
                                                                          .tool = tool,
                                                                          .speed = speed,
                                                                          .dt = CycleSettings{}.dt(),
                                                                          .seed = 1});
    start.scene = watch.lap();
    Cycle cycle(organ, tool, scene.start, CycleSettings{}, SpringSettings{});
    cycle.move(scene.poses.front());
    cycle.detect();
    start.cycle = watch.lap();
    return start;
}

/// Runs `action` in a child that has none of this process's memory to speak of: this one never holds a mesh.
/// Its peak resident memory, bytes.
template <typename Action>
double peak_of_child(const Action& action) {
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("cannot start a process");
    if (process == 0) {
        action();
        _exit(EXIT_SUCCESS);
    }
    int status = 0;
    rusage used{};
    if (wait4(process, &status, 0, &used) < 0 || status != 0) throw std::runtime_error("the child failed");
    constexpr double kilobyte = 1024;
    return static_cast<double>(used.ru_maxrss) * kilobyte;
}

void time_start(benchmark::State& state, int facets) {
    std::string name = (std::filesystem::temp_directory_path() / "trocar-start-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
    const std::filesystem::path folder = name, file = folder / "sphere.off";
    peak_of_child([&] { write_off(file, facets); });
    Start start{};
    double peak = 0;
    for (auto _ : state) {
        std::array<int, 2> line{};
        if (pipe(line.data()) != 0) throw std::runtime_error("cannot make a pipe");
        peak = peak_of_child([&] {
            const Start made = start_from(file);
            if (write(line[1], &made, sizeof made) != sizeof made) _exit(EXIT_FAILURE);
        });
        if (read(line[0], &start, sizeof start) != sizeof start) throw std::runtime_error("nothing came");
        close(line[0]);
        close(line[1]);
        state.SetIterationTime(start.organ + start.scene + start.cycle);
    }
    state.counters["organ_s"] = start.organ;
    state.counters["scene_s"] = start.scene;
    state.counters["cycle_s"] = start.cycle;
    state.counters["peak_B"] = peak;
    state.counters["file_B"] = static_cast<double>(std::filesystem::file_size(file));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    for (const int facets : {30'000, 1'000'000}) {
        const std::string name = fmt::format("start/{}", facets);
        benchmark::RegisterBenchmark(name.c_str(), trocar::time_start, facets)
            ->UseManualTime()
            ->Iterations(1)
            ->Repetitions(3)
            ->DisplayAggregatesOnly()
            ->Unit(benchmark::kSecond);
    }
    return trocar::run_benchmarks(argc, argv);
}
