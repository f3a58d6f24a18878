#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/claims/claims_plan.h"
#include "experiments/cli/analysis_program.h"
#include "experiments/cli/better_directions.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/shipped_files.h"
#include "experiments/cli/stop_on_signal.h"
#include "experiments/input_error.h"
#include "experiments/run/build_info.h"
#include "experiments/run/progress.h"
#include "experiments/run/provenance.h"
#include "experiments/run/run_sweep.h"
#include "experiments/run/workers/memory_use.h"
#include "experiments/say.h"
#include "experiments/sweep/hash.h"
#include "experiments/turns/turns.h"
#include "results/store.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer =
    "Runs the cases that the claims need, each once, and judges every claim under both readings of how long "
    "a\n"
    "handled vertex is held. A run that was cut off goes on when it is started again; a quick run's cases "
    "are part\n"
    "of a full one's. What the claims, their conditions and thresholds are stands in "
    "experiments/claims.toml.\n"
    "Exit codes: 0 the claims were judged, whatever the verdicts; 2 bad usage or input; 3 the results cannot "
    "be\n"
    "written; 130 interrupted (Ctrl-C), finished cases kept.\n"
    "Example:\n"
    "  trocar reproduce --quick\n"
    "  trocar reproduce --claims C3,C7 -o claims.h5 --markdown";

struct ReproduceOptions {
    std::string out = "claims.h5";
    std::string claims_file;
    std::vector<std::string> claims;
    std::string confirmation;
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
    bool quick = false, markdown = false, json = false;
};

ClaimsPlan make_plan(const ReproduceOptions& options, const fs::path& claims_file) {
    ClaimsWish wish{.chosen = options.claims, .is_quick = options.quick, .meshes = {}};
    if (!options.confirmation.empty()) wish.meshes = options.confirmation;
    if (wish.meshes && !fs::is_directory(*wish.meshes))
        throw InputError(fmt::format("--confirmation {}: is no folder", wish.meshes->string()));
    return plan_claims(claims_file, wish);
}

/// What all sweeps have in common. Every case of every sweep is in the order, whatever is asked for now, and
/// so are those that the file holds already: nothing of it is lost.
RunRequest common_request(const ReproduceOptions& options, const ClaimsPlan& plan, const Program& program) {
    RunRequest request;
    request.out = options.out;
    request.header = {.created_utc = now_utc(),
                      .generator = fmt::format("trocar {}", program_version()),
                      .sweep_toml = plan.text,
                      .sweep_hash = hash_of(plan.text),
                      .sweep_cases = {}};
    request.case_order = plan.case_order;
    if (fs::exists(request.out)) {
        for (const Contents::Case& one : read_contents(request.out).cases) {
            if (std::ranges::find(request.case_order, one.case_id) == request.case_order.end())
                request.case_order.push_back(one.case_id);
        }
    }
    request.jobs = options.jobs;
    request.limits = {.bytes = available_memory() / options.jobs};
    request.build_id = build_id();
    request.arguments = program.arguments;
    return request;
}

RunRequest request_of(const ClaimSweep& one, RunRequest request) {
    request.cases = one.cases;
    request.options = {.replay = false,
                       .metrics = one.metrics,
                       .same_state = one.sweep.same_state,
                       .answering = one.sweep.strategies};
    return request;
}

/// Runs one sweep after the other. @returns whether all were run to their ends
bool run_sweeps(const ReproduceOptions& options, const ClaimsPlan& plan, const Program& program) {
    const StopOnSignal signals;
    const RunRequest common = common_request(options, plan, program);
    for (const ClaimSweep& one : plan.sweeps) {
        if (one.cases.empty()) continue;
        const RunRequest request = request_of(one, common);
        const auto start = std::chrono::steady_clock::now();
        say("{}: {} cases\n", one.sweep.name, request.cases.size());
        RunOutcome outcome;
        {
            Progress progress(stderr);
            outcome = run_sweep(
                request, [&](std::size_t done, std::size_t total) { progress.show(done, total); },
                signals.token());
        }
        for (const std::string& line : outcome.failures) say("{}\n", line);
        const auto wall = std::chrono::steady_clock::now() - start;
        say("{}: {} from an earlier run, {} run in {}\n", one.sweep.name, outcome.kept, outcome.ran,
            duration_text(std::chrono::round<std::chrono::seconds>(wall)));
        if (outcome.interrupted) return false;
    }
    return true;
}

/// Measures how far answers turn for inputs that are almost the same, of every strategy of the sweeps.
void run_turns(const ReproduceOptions& options, const ClaimsPlan& plan) {
    std::vector<StrategyChoice> strategies;
    std::vector<std::uint64_t> seeds;
    for (const ClaimSweep& one : plan.sweeps) {
        for (const StrategyChoice& strategy : one.sweep.strategies) {
            if (std::ranges::find(strategies, strategy.label, &StrategyChoice::label) == strategies.end())
                strategies.push_back(strategy);
        }
        if (one.sweep.seeds.size() > seeds.size()) seeds = one.sweep.seeds;
    }
    write_turns(turns_beside(options.out), measure_turns(strategies, seeds));
}

/// What the analysis reads of the file of claims, before anything is run: a mistake in a condition must not
/// show after half an hour.
int check_conditions(const fs::path& claims_file) {
    return run_analysis({"claims", "--check", "--", claims_file.string()});
}

int judge(const ReproduceOptions& options, const ClaimsPlan& plan, const fs::path& claims_file) {
    std::vector<std::string> words{"claims", "--better=" + better_directions()};
    if (!options.claims.empty()) words.push_back(fmt::format("--only={}", fmt::join(options.claims, ",")));
    if (plan.needs_turns) words.push_back("--turns=" + turns_beside(options.out).string());
    if (options.markdown) words.emplace_back("--markdown");
    if (options.json) words.emplace_back("--json");
    words.insert(words.end(), {"--", claims_file.string(), options.out});
    return run_analysis(words);
}

int reproduce(const ReproduceOptions& options, const Program& program) {
    const fs::path claims_file =
        options.claims_file.empty() ? find_shipped("experiments/claims.toml") : fs::path(options.claims_file);
    const ClaimsPlan plan = make_plan(options, claims_file);
    if (const int code = check_conditions(claims_file); code != ExitCode::done) return code;
    for (const std::string& line : plan.left_out) say("{}\n", line);
    try {
        if (!run_sweeps(options, plan, program)) {
            say("interrupted; the same command goes on from here\n");
            return ExitCode::interrupted;
        }
        if (plan.needs_turns) run_turns(options, plan);
    } catch (const StoreError& error) {
        say("trocar: {}\nfinished cases are kept; once it can be written, the same command goes on\n",
            error.what());
        return ExitCode::case_failed;
    }
    return judge(options, plan, claims_file);
}

}  // namespace

void add_reproduce(CLI::App& app, Program& program) {
    auto options = std::make_shared<ReproduceOptions>();
    CLI::App* command = app.add_subcommand(
        "reproduce", "Judge every claim of the paper: run what it needs, print what holds");
    command->footer(footer);
    command->add_option("-o,--output", options->out, "result file (HDF5); goes on with an earlier one")
        ->capture_default_str();
    command
        ->add_option("--claims", options->claims,
                     "ids with commas between them, such as C3,C7; without it: all")
        ->delimiter(',');
    command->add_flag("--quick", options->quick, "fewer seeds: minutes instead of half an hour");
    command->add_option(
        "--confirmation", options->confirmation,
        "folder with the mesh files of the confirmation set, which has no part in the verdicts");
    command->add_option("--claims-file", options->claims_file,
                        "the claims (TOML); without it those that come with the program");
    command->add_option("-j,--jobs", options->jobs, "cases that run at once; results do not depend on it")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    CLI::Option* markdown = command->add_flag("--markdown", options->markdown, "print Markdown");
    command->add_flag("--json", options->json, "print every number as JSON")->excludes(markdown);
    command->callback([options, &program] { program.exit_code = reproduce(*options, program); });
}

}  // namespace trocar
