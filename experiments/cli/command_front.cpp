#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/picture_options.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "A point per strategy: its medians of both figures, with 95 % intervals. On the front, in bold and\n"
    "joined, are those that no other strategy beats: none is as good in both figures and better in one. A\n"
    "failed case is the worst; conditions that a strategy lacks are left out and counted. Of each figure "
    "one\n"
    "way has to be better: trocar list metrics says which.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar front results.h5 --metric tool_volume_inside_d_max --against time_handle_p99 -o front.svg\n"
    "  trocar front results.h5 --metric depth_max_d_max --against gap_mean_d_mean -o front.png --csv";

struct FrontOptions : PictureOptions {
    std::string metric, against;
};

}  // namespace

void add_front(CLI::App& app, Program& program) {
    auto options = std::make_shared<FrontOptions>();
    CLI::App* command = app.add_subcommand("front", "Draw the Pareto front of two figures");
    command->footer(footer);
    add_picture_options(*command, *options);
    command
        ->add_option(
            "--metric", options->metric,
            "the figure along y: a column, a metric of one column, or a quotient of two columns, A/B")
        ->required();
    command->add_option("--against", options->against, "the figure along x, likewise")->required();
    command->callback([options, &program] {
        program.exit_code = run_analysis(
            options->words({"front", "--metric=" + options->metric, "--against=" + options->against}));
    });
}

}  // namespace trocar
