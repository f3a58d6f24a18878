// The fuzzy inference: fuzzylite's own evaluation of the rule base that ships, and ours of the same file.
#include <chrono>
#include <random>

#include <benchmark/benchmark.h>

#include "tests/benchmarks/bench_main.h"
#include "tests/strategies/fuzzy/fuzzylite_engine.h"
#include "tests/strategies/fuzzy/paper_rules.h"

namespace trocar::fuzzy {
namespace {

/// A facet as the inference meets it.
struct Facet {
    double collision_index;
    Weights previous;
    bool first;
};

/// As around vertices of six facets: every sixth is a first one.
std::vector<Facet> facets() {
    std::mt19937 generator(2009);  // NOLINT(bugprone-random-generator-seed): the same in every run
    std::uniform_real_distribution<> unit(0, 1);
    std::vector<Facet> all;
    for (int k = 0; k < 600; ++k) {
        all.push_back({.collision_index = 2 * unit(generator) - 1,
                       .previous = {unit(generator), unit(generator), unit(generator)},
                       .first = k % 6 == 0});
    }
    return all;
}

template <typename Evaluate>
void run(benchmark::State& state, const Evaluate& evaluate) {
    const std::vector<Facet> all = facets();
    for (auto _ : state) {
        for (const Facet& facet : all) benchmark::DoNotOptimize(evaluate(facet));
    }
    state.counters["per_facet"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(all.size()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void fuzzylite(benchmark::State& state) {
    FuzzyliteEngine engine(shipped_rules());
    run(state, [&](const Facet& facet) {
        return engine.evaluate(facet.collision_index, facet.previous, facet.first);
    });
}

void inference(benchmark::State& state) {
    const Inference& rules = paper_inference();
    run(state, [&](const Facet& facet) {
        return facet.first ? rules.first(facet.collision_index)
                           : rules.further(facet.collision_index, facet.previous);
    });
}

/// Both in turn in one run: the counter is how many times as long fuzzylite takes.
void fuzzylite_over_inference(benchmark::State& state) {
    using Clock = std::chrono::steady_clock;
    FuzzyliteEngine engine(shipped_rules());
    const Inference& rules = paper_inference();
    const std::vector<Facet> all = facets();
    Clock::duration theirs{}, ours{};
    for (auto _ : state) {
        const auto start = Clock::now();
        for (const Facet& one : all) {
            benchmark::DoNotOptimize(engine.evaluate(one.collision_index, one.previous, one.first));
        }
        const auto middle = Clock::now();
        for (const Facet& one : all) {
            benchmark::DoNotOptimize(one.first ? rules.first(one.collision_index)
                                               : rules.further(one.collision_index, one.previous));
        }
        ours += Clock::now() - middle;
        theirs += middle - start;
    }
    state.counters["ratio"] = static_cast<double>(theirs.count()) / static_cast<double>(ours.count());
}

}  // namespace
}  // namespace trocar::fuzzy

int main(int argc, char** argv) {
    for (benchmark::internal::Benchmark* one :
         {benchmark::RegisterBenchmark("fuzzy/fuzzylite", trocar::fuzzy::fuzzylite),
          benchmark::RegisterBenchmark("fuzzy/inference", trocar::fuzzy::inference),
          benchmark::RegisterBenchmark("fuzzy/fuzzylite_over_inference",
                                       trocar::fuzzy::fuzzylite_over_inference)}) {
        one->Repetitions(5)->DisplayAggregatesOnly();
    }
    return trocar::run_benchmarks(argc, argv);
}
