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
    "For papers: each diagram as SVG and PDF, readable in grey, a LaTeX table (booktabs) per metric, and "
    "captions\n"
    "that say how many cases there were and which test was used. Figures of a single step are drawn by "
    "trocar\n"
    "figure and trocar snapshot.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar figures results.h5 -o figures\n"
    "  trocar figures results.h5 -o figures --only release=contact --metric depth_max_d_max";

struct FiguresOptions {
    std::string file, output;
    std::vector<std::string> filters, metrics;

    [[nodiscard]] std::vector<std::string> words() const {
        std::vector<std::string> words{"figures", "--output=" + output, "--better=" + better_directions()};
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        for (const std::string& metric : metrics) words.push_back("--metric=" + metric);
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_figures(CLI::App& app, Program& program) {
    auto options = std::make_shared<FiguresOptions>();
    CLI::App* command = app.add_subcommand("figures", "Draw a result file's diagrams and tables for a paper");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command->add_option("-o,--output", options->output, "folder for the figures, made where it is missing")
        ->required();
    command
        ->add_option("--only", options->filters,
                     "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    command
        ->add_option("--metric", options->metrics,
                     "a column, or a metric for all its columns; may be given several times")
        ->allow_extra_args(false);
    command->callback([options, &program] { program.exit_code = run_analysis(options->words()); });
}

}  // namespace trocar
