#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "common/nearest_name.h"
#include "experiments/cli/commands.h"
#include "experiments/input_error.h"
#include "experiments/run/build_info.h"
#include "experiments/say.h"

namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 1 a result says no; 2 bad usage or input, or a file that cannot be read or "
    "written;\n"
    "3 a case did not complete, or the analysis has a bug; 130 interrupted.\n"
    "Example:\n"
    "  trocar run sweep.toml -o results.h5\n"
    "  trocar show results.h5\n"
    "Each command has its own help: trocar run --help";

std::string version_text() {
    return fmt::format("trocar {} (commit {}{}, {})", trocar::program_version(), trocar::git_commit(),
                       trocar::git_dirty() ? ", with changes" : "", trocar::compiler());
}

/// CLI11 says of a misspelt command only that one is required.
void check_command(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    throw trocar::InputError(trocar::unknown_name("command", word, names));
}

int run_program(int argc, char** argv) {
    trocar::Program program;
    program.arguments.assign(argv, argv + argc);
    CLI::App app(
        "Runs a surgical scene under each of many collision-handling strategies and measures what each "
        "leaves behind.",
        "trocar");
    app.set_version_flag("--version", version_text);
    app.footer(footer);
    app.require_subcommand(1);
    trocar::add_run(app, program);
    trocar::add_reproduce(app, program);
    trocar::add_merge(app, program);
    trocar::add_list(app, program);
    trocar::add_show(app, program);
    trocar::add_compare(app, program);
    trocar::add_sensitivity(app, program);
    trocar::add_rank(app, program);
    trocar::add_front(app, program);
    trocar::add_snapshot(app, program);
    trocar::add_figure(app, program);
    trocar::add_report(app, program);
    trocar::add_figures(app, program);
    trocar::add_export(app, program);
    trocar::add_check(app, program);
    trocar::add_bench(app, program);
    trocar::add_fuzzy(app, program);
    if (argc > 1) check_command(app, program.arguments[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? trocar::ExitCode::done : trocar::ExitCode::bad_input;
    }
    return program.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const std::exception& error) {
        trocar::say("trocar: {}\n", error.what());
        return trocar::ExitCode::bad_input;
    }
}
