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
    "A point per strategy: its medians of both figures, with 95 % intervals. On the front, in bold and\n"
    "joined, are those that no other strategy beats: none is as good in both figures and better in one. A\n"
    "failed case is the worst; conditions that a strategy lacks are left out and counted. Of each figure "
    "one\n"
    "way has to be better: trocar list metrics says which.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar front results.h5 --metric tool_volume_inside_d_max --against time_handle_p99 -o front.svg\n"
    "  trocar front results.h5 --metric depth_max_d_max --against gap_mean_d_mean -o front.png --csv";

struct FrontOptions {
    std::string file, metric, against;
    std::vector<std::string> outputs, filters;
    bool csv = false, markdown = false;

    [[nodiscard]] std::vector<std::string> arguments() const {
        std::vector<std::string> words{"front", "--metric=" + metric, "--against=" + against,
                                       "--better=" + better_directions()};
        for (const std::string& output : outputs) words.push_back("--output=" + output);
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        if (csv) words.emplace_back("--csv");
        if (markdown) words.emplace_back("--markdown");
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_front(CLI::App& app, Program& program) {
    auto options = std::make_shared<FrontOptions>();
    CLI::App* command = app.add_subcommand("front", "Draw the Pareto front of two figures");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command
        ->add_option(
            "--metric", options->metric,
            "the figure along y: a column, a metric of one column, or a quotient of two columns, A/B")
        ->required();
    command->add_option("--against", options->against, "the figure along x, likewise")->required();
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
