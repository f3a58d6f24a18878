#include <cstdio>
#include <exception>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "experiments/cli/commands.h"
#include "experiments/run/build_info.h"

namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 1 a result says no; 2 bad usage or input, or a file that cannot be read or "
    "written;\n"
    "3 a case did not complete; 130 interrupted.\n"
    "Example:\n"
    "  trocar run sweep.toml -o results.h5\n"
    "  trocar show results.h5\n"
    "Each command has its own help: trocar run --help";

std::string version_text() {
    return fmt::format("trocar {} (commit {}{}, {})", trocar::program_version(), trocar::git_commit(),
                       trocar::git_dirty() ? ", with changes" : "", trocar::compiler());
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
    trocar::add_list(app, program);
    trocar::add_show(app, program);
    trocar::add_snapshot(app, program);
    trocar::add_check(app, program);
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
        std::fprintf(stderr, "trocar: %s\n", error.what());
        return trocar::ExitCode::bad_input;
    }
}
