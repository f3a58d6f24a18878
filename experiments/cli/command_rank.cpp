#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/better_directions.h"
#include "experiments/cli/commands.h"

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

struct RankOptions {
    std::string file, metric;
    std::vector<std::string> outputs, filters;
    bool csv = false, markdown = false;

    [[nodiscard]] std::vector<std::string> arguments() const {
        std::vector<std::string> words{"rank", "--metric=" + metric, "--better=" + better_directions()};
        for (const std::string& output : outputs) words.push_back("--output=" + output);
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        if (csv) words.emplace_back("--csv");
        if (markdown) words.emplace_back("--markdown");
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_rank(CLI::App& app, Program& program) {
    auto options = std::make_shared<RankOptions>();
    CLI::App* command = app.add_subcommand("rank", "Rank the strategies by one figure, with tests");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command
        ->add_option("--metric", options->metric,
                     "the figure: a column, a metric of one column, or a quotient of two columns, A/B")
        ->required();
    command
        ->add_option("-o,--output", options->outputs,
                     "picture, .svg or .png; may be given several times for the same in several files")
        ->required()
        ->allow_extra_args(false);
    command
        ->add_option("--only", options->filters,
                     "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    CLI::Option* csv = command->add_flag("--csv", options->csv, "comma-separated, in full precision");
    command->add_flag("--markdown", options->markdown, "a Markdown table")->excludes(csv);
    command->callback([options, &program] { program.exit_code = run_analysis(options->arguments()); });
}

}  // namespace trocar
