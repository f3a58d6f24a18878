#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "experiments/cli/commands.h"
#include "experiments/run/merge_results.h"
#include "experiments/say.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "A folder stands for the result files (*.h5) in it, such as the parts that a run left. Of a case that "
    "several\n"
    "files hold, a complete one is taken before one that is not, of one program the one that has more, else "
    "the\n"
    "one that ended last. OUT.h5 is replaced when the new one is whole; one that "
    "holds\n"
    "cases which no input holds is left as it is. What is missing, trocar run SWEEP -o OUT.h5 runs.\n"
    "Exit codes: 0 every case of the sweep is there and complete; 2 bad usage or input, nothing written;\n"
    "3 a case is missing or did not complete, or OUT.h5 cannot be written.\n"
    "Example:\n"
    "  trocar run sweep.toml -o one.h5 --shard 1/2      # on one machine\n"
    "  trocar run sweep.toml -o two.h5 --shard 2/2      # on another\n"
    "  trocar merge one.h5 two.h5 -o results.h5";

struct MergeOptions {
    std::vector<std::string> inputs;
    std::string out;
    bool tables_only = false;
};

/// @returns whether nothing is missing, as far as is known
bool tell_missing(const MergeOutcome& outcome) {
    if (!outcome.sweep_cases) {
        fmt::print("how many cases the sweep has is not known: the files do not say\n");
        return true;
    }
    if (outcome.cases >= *outcome.sweep_cases) return true;
    fmt::print("{} of the sweep's {} cases are missing; trocar run runs them\n",
               *outcome.sweep_cases - outcome.cases, *outcome.sweep_cases);
    return false;
}

int run_merge(const MergeOptions& options) {
    const std::vector<std::filesystem::path> inputs(options.inputs.begin(), options.inputs.end());
    MergeOutcome outcome;
    try {
        outcome =
            merge_results(inputs, options.out, options.tables_only ? Merged::tables : Merged::everything);
    } catch (const StoreError& error) {
        say("trocar: {}\nnothing was merged; the inputs are as they were\n", error.what());
        return ExitCode::case_failed;
    }
    for (const std::string& line : outcome.warnings) say("{}\n", line);
    std::string counts;
    for (const auto& [status, count] : outcome.by_status)
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, status);
    fmt::print("{} cases from {} files: {}\n", outcome.cases, outcome.files, counts);
    if (outcome.left_out > 0) {
        fmt::print("{} results were left out: another file holds the same case from later\n",
                   outcome.left_out);
    }
    if (!outcome.in_order)
        fmt::print("in the order of the files: they do not say what the sweep's order is\n");
    const bool all_there = tell_missing(outcome);
    fmt::print("result file: {}\n", options.out);
    if (!outcome.xdmf.empty()) fmt::print("for ParaView: {}\n", outcome.xdmf.string());
    const bool all_complete = outcome.by_status.size() == 1 && outcome.by_status.contains("complete");
    return all_there && all_complete ? ExitCode::done : ExitCode::case_failed;
}

}  // namespace

void add_merge(CLI::App& app, Program& program) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = app.add_subcommand("merge", "Merge result files of one sweep into one");
    command->footer(footer);
    command->add_option("RESULTS", options->inputs, "result files, and folders of them")->required();
    command->add_option("-o,--output", options->out, "result file to write")->required();
    command->add_flag("--tables-only", options->tables_only,
                      "without the series of every step and the replays: what show, compare and reproduce "
                      "read, small enough to be sent");
    command->callback([options, &program] { program.exit_code = run_merge(*options); });
}

}  // namespace trocar
