#include "tests/benchmarks/bench_main.h"

#include <string>

#include <benchmark/benchmark.h>

#include "experiments/run/build_info.h"
#include "experiments/run/provenance.h"

namespace trocar {
int run_benchmarks(int argc, char** argv) {
    benchmark::AddCustomContext("cpu", cpu_model());
    benchmark::AddCustomContext("compiler", std::string(compiler()));
    benchmark::AddCustomContext("flags", std::string(compiler_flags()));
    benchmark::AddCustomContext("commit", std::string(git_commit()));
    benchmark::AddCustomContext("commit_is_all", git_dirty() ? "no, the tree had changes" : "yes");
    benchmark::AddCustomContext("libraries", std::string(library_versions()));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

}  // namespace trocar
