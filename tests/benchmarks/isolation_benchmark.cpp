// What it costs to run every case in a process of its own, and what a second job brings. See README.md.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX
#include <sys/wait.h>
#include <unistd.h>

#include "experiments/run/batches.h"
#include "experiments/run/run_case.h"
#include "experiments/run/run_sweep.h"
#include "experiments/run/shared_scenes.h"
#include "experiments/run/workers/supervise.h"
#include "experiments/sweep/hash.h"
#include "results/store.h"
#include "tests/benchmarks/bench_main.h"

namespace trocar {
namespace {

using Clock = std::chrono::steady_clock;

// Cases of the kinds that paper.toml has.
constexpr std::string_view sweep_text = R"(name = "isolation"
strategies = ["fuzzy-per-vertex", "nearest-face", "cylinder-axis", "average-plane", "joint-vertex", "tool-facet"]
organs = ["sphere@4mm", "gallbladder@2mm"]
tools = ["prism-12"]
scenes = ["penetration", "sliding"]
speeds = [20, 100, 400]
seeds = 2
)";

/// A sweep in a folder of its own, which is removed with it.
class Campaign {
  public:
    Campaign() {
        std::string name = (std::filesystem::temp_directory_path() / "trocar-isolation-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
        folder_ = name;
        std::ofstream(folder_ / "sweep.toml") << sweep_text;
        cases_ = by_scene(list_cases(read_sweep(folder_ / "sweep.toml")));
    }
    Campaign(const Campaign&) = delete;
    Campaign& operator=(const Campaign&) = delete;
    ~Campaign() { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::span<const CaseInputs> cases() const { return cases_; }
    [[nodiscard]] std::filesystem::path path(std::string_view name) const { return folder_ / name; }

    [[nodiscard]] RunRequest request(std::string_view out, std::vector<CaseInputs> cases,
                                     unsigned jobs) const {
        RunRequest request;
        request.out = path(out);
        request.header = {.created_utc = "2009-11-05T12:00:00Z",
                          .generator = "isolation_benchmark",
                          .sweep_toml = std::string(sweep_text),
                          .sweep_hash = hash_of(std::string(sweep_text))};
        request.cases = std::move(cases);
        for (const CaseInputs& inputs : request.cases) request.case_order.push_back(inputs.case_id);
        request.jobs = jobs;
        request.build_id = "benchmark";
        return request;
    }

    /// Does the tasks of a batch as a sweep does: the scene is shared, each case is written as a file.
    void work(const Batch& batch, const Reports& report) const {
        SharedScenes scenes{cases().subspan(batch.begin, batch.end - batch.begin)};
        const SceneSource scene_of = [&](const CaseInputs& inputs) { return scenes.scene_of(inputs); };
        const RunRequest header_of = request("", {}, 1);
        for (std::uint64_t task = batch.begin; task < batch.end; ++task) {
            const auto strategy = make_strategy(cases_[task].strategy.name, cases_[task].strategy.options);
            CaseRecord record = *run_case(cases_[task], scene_of, *strategy, CaseOptions{}, {});
            record.build_id = header_of.build_id;
            write_case(path(cases_[task].case_id), header_of.header, record);
            report.done("done");
        }
    }

  private:
    std::filesystem::path folder_;
    std::vector<CaseInputs> cases_;
};

double milliseconds_of(const auto& action) {
    const auto start = Clock::now();
    action();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The same cases, in this process and in a supervised one, in turn.
void isolation(benchmark::State& state) {
    const Campaign campaign;
    const auto batches = batches_of(campaign.cases(), 1);
    const DoBatch work = [&](const Batch& batch, const Reports& report) { campaign.work(batch, report); };
    const Listener listener{.done = [](std::uint64_t, const std::string&) {},
                            .lost = [](const LostTask& lost) { throw std::runtime_error(lost.reason); }};
    double direct = 0, supervised = 0;
    for (auto _ : state) {
        supervised += milliseconds_of([&] { supervise(batches, 1, {}, {}, work, listener); });
        direct += milliseconds_of([&] {
            for (const Batch& batch : batches)
                work(batch, {.done = [](const std::string&) {}, .part = [](auto) {}});
        });
    }
    const double cases =
        static_cast<double>(state.iterations()) * static_cast<double>(campaign.cases().size());
    state.counters["cases"] = static_cast<double>(campaign.cases().size());
    state.counters["case_ms"] = direct / cases;
    state.counters["overhead_ms"] = (supervised - direct) / cases;
}

/// Runs the sweep in a process of its own.
pid_t start(const RunRequest& request) {
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("cannot start a process");
    if (process > 0) return process;
    run_sweep(request, [](std::size_t, std::size_t) {}, {});
    _exit(EXIT_SUCCESS);
}

void wait_for(pid_t process) {
    int status = 0;
    if (waitpid(process, &status, 0) < 0 || status != 0) throw std::runtime_error("a run did not succeed");
}

/// One run of two jobs, and two runs of one job side by side, each of all cases, in turn.
void two_jobs(benchmark::State& state) {
    const Campaign campaign;
    const std::vector<CaseInputs> all(campaign.cases().begin(), campaign.cases().end());
    const RunRequest together = campaign.request("together.h5", all, 2);
    const RunRequest first = campaign.request("first.h5", all, 1);
    const RunRequest second = campaign.request("second.h5", all, 1);
    double one_run = 0, two_runs = 0;
    for (auto _ : state) {
        for (const RunRequest* request : {&together, &first, &second}) std::filesystem::remove(request->out);
        one_run += milliseconds_of([&] { wait_for(start(together)); });
        two_runs += milliseconds_of([&] {
            const pid_t beside = start(first);
            wait_for(start(second));
            wait_for(beside);
        });
    }
    state.counters["cases"] = static_cast<double>(all.size());
    // Two runs do twice the cases.
    state.counters["throughput_ratio"] = two_runs / (2 * one_run);
}

}  // namespace
}  // namespace trocar

int main(int argc, char** argv) {
    for (benchmark::internal::Benchmark* one : {benchmark::RegisterBenchmark("isolation", trocar::isolation),
                                                benchmark::RegisterBenchmark("two_jobs", trocar::two_jobs)}) {
        one->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5);
    }
    return trocar::run_benchmarks(argc, argv);
}
