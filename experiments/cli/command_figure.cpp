#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Steps of runs that have stored replays (trocar run --replay), side by side and from the same view: "
    "solid\n"
    "or as wire models, with displacement vectors or without. What is on each panel says a TOML file; those "
    "of\n"
    "the paper's figures are analysis/figures/fig3.toml to fig6.toml.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing.\n"
    "Example:\n"
    "  trocar run experiments/figures/fig5.toml --replay -o fig5.h5\n"
    "  trocar figure fig5.h5 --panels analysis/figures/fig5.toml -o fig5.png";

struct FigureOptions {
    std::string file, panels, output;
};

}  // namespace

void add_figure(CLI::App& app, Program& program) {
    auto options = std::make_shared<FigureOptions>();
    CLI::App* command =
        app.add_subcommand("figure", "Draw steps of several cases side by side, as a file describes");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file of a run with --replay")->required();
    command->add_option("--panels", options->panels, "description of the figure, TOML")->required();
    command->add_option("-o,--output", options->output, "picture to write: .png or .svg")->required();
    command->callback([options, &program] {
        program.exit_code = run_analysis(
            {"figure", "--panels=" + options->panels, "--output=" + options->output, "--", options->file});
    });
}

}  // namespace trocar
