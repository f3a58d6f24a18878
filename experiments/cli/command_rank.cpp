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
    "A block of the tests is a seed on an organ, where a strategy goes by the mean of its ranks under every\n"
    "scene, tool, speed, rate and release. The diagram joins strategies whose mean ranks over the blocks\n"
    "differ by less than Nemenyi's critical difference. A failed case is the worst; conditions that a\n"
    "strategy lacks are left out and counted. Of the figure one way has to be better: trocar list metrics\n"
    "says which.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar rank results.h5 --metric depth_max_d_max -o depth.svg\n"
    "  trocar rank results.h5 --metric tool_volume_inside_d_max --only speed=400 -o x.svg -o x.png "
    "--markdown";

struct RankOptions : PictureOptions {
    std::string metric;
};

}  // namespace

void add_rank(CLI::App& app, Program& program) {
    auto options = std::make_shared<RankOptions>();
    CLI::App* command = app.add_subcommand("rank", "Rank the strategies by one figure, with tests");
    command->footer(footer);
    add_picture_options(*command, *options);
    command
        ->add_option("--metric", options->metric,
                     "the figure: a column, a metric of one column, or a quotient of two columns, A/B")
        ->required();
    command->callback([options, &program] {
        program.exit_code = run_analysis(options->words({"rank", "--metric=" + options->metric}));
    });
}

}  // namespace trocar
