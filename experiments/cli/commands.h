#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace trocar {

/// What the program ends with; `trocar --help` lists them.
struct ExitCode {
    static constexpr int done = 0;
    static constexpr int bad_input = 2;
    static constexpr int case_failed = 3;
    static constexpr int interrupted = 130;  // 128 + SIGINT, as shells have it
};

/// What the subcommands share with main.
struct Program {
    std::vector<std::string> arguments;  ///< the command line
    int exit_code = ExitCode::done;      ///< set by the subcommand that ran
};

/// @{
/// Adds one subcommand, which runs while `app` parses. Throws InputError and StoreError. `program`
/// must outlive the parsing.
void add_run(CLI::App& app, Program& program);
void add_merge(CLI::App& app, Program& program);
void add_list(CLI::App& app, Program& program);
void add_reproduce(CLI::App& app, Program& program);
void add_show(CLI::App& app, Program& program);
void add_compare(CLI::App& app, Program& program);
void add_sensitivity(CLI::App& app, Program& program);
void add_rank(CLI::App& app, Program& program);
void add_front(CLI::App& app, Program& program);
void add_snapshot(CLI::App& app, Program& program);
void add_figure(CLI::App& app, Program& program);
void add_report(CLI::App& app, Program& program);
void add_figures(CLI::App& app, Program& program);
void add_export(CLI::App& app, Program& program);
void add_check(CLI::App& app, Program& program);
void add_bench(CLI::App& app, Program& program);
void add_fuzzy(CLI::App& app, Program& program);
/// @}

}  // namespace trocar
