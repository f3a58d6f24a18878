#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "experiments/cli/commands.h"
#include "experiments/cli/stop_on_signal.h"
#include "experiments/input_error.h"
#include "experiments/run/build_info.h"
#include "experiments/run/done_cases.h"
#include "experiments/run/origins.h"
#include "experiments/run/progress.h"
#include "experiments/run/provenance.h"
#include "experiments/run/run_sweep.h"
#include "experiments/run/workers/memory_use.h"
#include "experiments/say.h"
#include "experiments/sweep/hash.h"
#include "experiments/sweep/shard.h"
#include "results/store.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "A run that was cut off goes on when it is started again: cases that are in the result file, from the "
    "same\n"
    "program, are not run again, unless they did not complete and --retry-failed is given. A result file of\n"
    "another sweep is never written over.\n"
    "With --fresh all cases asked for run again. Until the last of them is done they lie in "
    "OUT.h5.fresh.parts,\n"
    "and OUT.h5 stays as it is. A fresh run that was cut off goes on when it is started again with --fresh, "
    "as\n"
    "long as OUT.h5 does not have its cases; without, it is as if it had not been, and the folder can be "
    "removed.\n"
    "With --shard i/n several machines share a sweep, each with an output of its own and the same --only; "
    "trocar\n"
    "merge makes one file of them.\n"
    "Exit codes: 0 every case complete; 2 bad usage or input, nothing written; 3 a case did not complete, "
    "or\n"
    "the disk is full: finished cases are kept; 130 interrupted (Ctrl-C), finished cases kept.\n"
    "Example:\n"
    "  trocar run sweep.toml -o results.h5 --jobs 2 --only speed=100 --only seed=1";

struct RunOptions {
    std::string sweep_file;
    std::string out;
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::string> filters;
    bool dry_run = false;
    bool replay = false;
    bool retry_failed = false;
    bool fresh = false;
    std::string shard;
    bool timing = false;
    double case_seconds = TaskLimits{}.seconds;
    std::optional<double> case_gigabytes;
    std::string metrics = "all";
};

void tell_findings(const Sweep& sweep) {
    for (const OrganChoice& organ : sweep.organs) {
        for (const Finding& finding : organ.findings) {
            say("organ \"{}\": {}\n", organ.organ->name, describe(finding));
        }
    }
    for (const ToolChoice& tool : sweep.tools) {
        for (const Finding& finding : tool.findings) {
            say("tool \"{}\": {}\n", tool.tool->name, describe(finding));
        }
    }
}

std::vector<const Metric*> chosen(const std::string& metrics) {
    try {
        return choose_metrics(metrics);
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("--metrics {}: {}", metrics, error.what()));
    }
}

/// All cases that the sweep can run, whatever is asked for.
CaseList whole_list(const std::vector<CaseInputs>& cases) {
    std::string ids;
    for (const CaseInputs& inputs : cases) ids += inputs.case_id;
    return {.count = static_cast<std::int64_t>(cases.size()), .ids_hash = hash_of(ids)};
}

RunRequest make_request(const RunOptions& options, const Sweep& sweep, const Program& program) {
    RunRequest request;
    request.out = options.out;
    request.header = {.created_utc = now_utc(),
                      .generator = fmt::format("trocar {}", program_version()),
                      .sweep_toml = sweep.text,
                      .sweep_hash = hash_of(sweep.text)};
    request.cases = list_cases(sweep);
    for (const CaseInputs& inputs : request.cases) request.case_order.push_back(inputs.case_id);
    request.header.sweep_cases = whole_list(suited(request.cases).cases);
    SuitedCases suited_cases = suited(only(std::move(request.cases), options.filters));
    for (const std::string& line : suited_cases.left_out) say("{}\n", line);
    if (suited_cases.cases.empty()) throw InputError("no case is left to run");
    request.cases = std::move(suited_cases.cases);
    if (!options.shard.empty())
        request.cases = in_shard(std::move(request.cases), parse_shard(options.shard));
    request.jobs = options.jobs;
    request.timing = options.timing;
    request.limits = {.seconds = options.case_seconds,
                      .bytes = options.case_gigabytes
                                   ? static_cast<std::uint64_t>(*options.case_gigabytes * 1e9)
                                   : available_memory() / options.jobs};
    request.options = {.replay = options.replay,
                       .metrics = chosen(options.metrics),
                       .same_state = sweep.same_state,
                       .answering = sweep.strategies};
    request.build_id = build_id();
    request.retry_failed = options.retry_failed;
    request.fresh = options.fresh;
    request.arguments = program.arguments;
    return request;
}

void print_plan(const RunOptions& options, const RunRequest& request) {
    const std::vector<CaseInputs> pending = request.out.empty() ? request.cases : pending_cases(request);
    std::set<std::string> pending_ids;
    for (const CaseInputs& inputs : pending) pending_ids.insert(inputs.case_id);
    for (const CaseInputs& inputs : request.cases) {
        fmt::print("{}  {}, {}, {}, {}, {} mm/s, seed {}{}\n", inputs.case_id, inputs.strategy.label,
                   inputs.organ.organ->name, inputs.tool.tool->name, inputs.scene.name, inputs.speed,
                   inputs.seed, pending_ids.contains(inputs.case_id) ? "" : "  (done)");
    }
    fmt::print("{}{} cases, {} of them to run; nothing was run\n",
               options.shard.empty() ? "" : fmt::format("shard {}: ", options.shard), request.cases.size(),
               pending.size());
}

int exit_code_of(const RunOutcome& outcome) {
    if (outcome.interrupted) return ExitCode::interrupted;
    const bool all_complete = outcome.by_status.size() == 1 && outcome.by_status.contains("complete");
    return all_complete ? ExitCode::done : ExitCode::case_failed;
}

void print_outcome(const RunOutcome& outcome, const RunRequest& request, std::chrono::seconds wall) {
    for (const std::string& line : outcome.failures) say("{}\n", line);
    std::string counts;
    std::size_t stored = 0;
    for (const auto& [status, count] : outcome.by_status) {
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, status);
        stored += count;
    }
    fmt::print("{} of {} cases: {} ({} from an earlier run, {} run in {})\n", stored, request.cases.size(),
               counts.empty() ? "none done" : counts, outcome.kept, outcome.ran, duration_text(wall));
    if (outcome.interrupted) fmt::print("interrupted; the same command goes on from here\n");
    if (outcome.kept > 0 && exit_code_of(outcome) == ExitCode::case_failed)
        fmt::print("to run again those that did not complete: --retry-failed\n");
    if (stored == 0) return;
    if (!outcome.merged) {
        fmt::print("{} is as it was before; the new cases wait in {}\n", request.out.string(),
                   fresh_parts_folder_of(request.out).string());
        return;
    }
    for (const std::string& line : mixed_origins(read_contents(request.out).cases)) say("{}\n", line);
    fmt::print("result file: {}\n", request.out.string());
    if (!outcome.xdmf.empty()) fmt::print("for ParaView: {}\n", outcome.xdmf.string());
    fmt::print("look at it: trocar show {}\n", request.out.string());
}

/// The disk is full, or the folder is gone.
void tell_unwritten(const RunRequest& request, const StoreError& error) {
    const auto parts = request.fresh ? fresh_parts_folder_of(request.out) : parts_folder_of(request.out);
    std::error_code gone;
    const bool kept = std::filesystem::exists(parts, gone);
    say("trocar: {}\n{}; once it can be written, the same command goes on\n", error.what(),
        kept ? fmt::format("finished cases are kept in {}", parts.string())
             : fmt::format("no case is kept that is not in {}", request.out.string()));
}

int run(const RunOptions& options, const Program& program) {
    if (options.out.empty() && !options.dry_run) {
        throw InputError("run needs an output: -o OUT.h5");
    }
    const Sweep sweep = read_sweep(options.sweep_file);
    tell_findings(sweep);
    const RunRequest request = make_request(options, sweep, program);
    if (options.dry_run) {
        print_plan(options, request);
        return ExitCode::done;
    }
    const auto start = std::chrono::steady_clock::now();
    const StopOnSignal signals;
    RunOutcome outcome;
    try {
        Progress progress(stderr);
        outcome = run_sweep(
            request, [&](std::size_t done, std::size_t total) { progress.show(done, total); },
            signals.token());
    } catch (const StoreError& error) {
        tell_unwritten(request, error);
        return ExitCode::case_failed;
    }
    const auto wall = std::chrono::steady_clock::now() - start;
    print_outcome(outcome, request, std::chrono::round<std::chrono::seconds>(wall));
    return exit_code_of(outcome);
}

/// CLI11's own check lets NaN and infinity pass.
std::string above_zero(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && *end == '\0' && std::isfinite(number);
    return is_number && number > 0 ? "" : fmt::format("{}: expected a number above zero", text);
}

}  // namespace

void add_run(CLI::App& app, Program& program) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* command = app.add_subcommand("run", "Run the cases of a sweep and write what they leave");
    command->footer(footer);
    command->add_option("SWEEP", options->sweep_file, "sweep file (TOML)")->required();
    command->add_option("-o,--output", options->out,
                        "result file (HDF5); goes on with one of the same sweep");
    command->add_option("-j,--jobs", options->jobs, "cases that run at once; results do not depend on it")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    command
        ->add_option(
            "--only", options->filters,
            "key=value: run these cases only. Keys: strategy (name or label), label, organ, tool, scene, "
            "speed, "
            "seed, rate, release, edge_stiffness, rest_stiffness, an option's name. May be given several "
            "times: values of one key are alternatives")
        ->allow_extra_args(false);
    command
        ->add_option("--case-seconds", options->case_seconds,
                     "a case that takes longer is given up: status timed_out")
        ->check(above_zero)
        ->capture_default_str();
    command
        ->add_option("--case-gigabytes", options->case_gigabytes,
                     "a case that takes more memory is given up: status out_of_memory; without it its "
                     "job's share of what the machine has")
        ->check(above_zero);
    command->add_flag("--timing", options->timing,
                      "one case at a time on one core, strategies taking turns: for times that can be "
                      "compared");
    command->add_flag("--dry-run", options->dry_run,
                      "check everything and list the cases; run and write nothing");
    command
        ->add_option("--metrics", options->metrics,
                     "what to measure: all, fast (what costs little), or names with commas between them; see "
                     "trocar list metrics")
        ->capture_default_str();
    command->add_option("--shard", options->shard,
                        "i/n: the i-th of n parts of the cases, all about as large; scenes stay whole");
    CLI::Option* retry = command->add_flag("--retry-failed", options->retry_failed,
                                           "run again the cases that did not complete, too");
    command->add_flag("--fresh", options->fresh, "run everything again; the old result file stays until then")
        ->excludes(retry);
    command->add_flag("--replay", options->replay,
                      "store the organ at every step too (large); for snapshots");
    command->callback([options, &program] { program.exit_code = run(*options, program); });
}

}  // namespace trocar
