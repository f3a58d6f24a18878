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
    "A row of panels per figure, a column per release, a line per strategy, and per speed where there are\n"
    "several: the median over the cases and its 95 % interval. A failed case counts as the worst value "
    "there\n"
    "is. COLUMN is a condition of the cases: organ_facets, organ, tool, scene, speed, rate, release,\n"
    "edge_stiffness, rest_stiffness.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the "
    "analysis.\n"
    "Example:\n"
    "  trocar sensitivity results.h5 --over speed -o speed.svg\n"
    "  trocar sensitivity results.h5 --over tool --metric depth_max_d_max -o tool.png --markdown";

struct SensitivityOptions {
    std::string file, over;
    std::vector<std::string> outputs, filters, metrics;
    bool csv = false, markdown = false;

    [[nodiscard]] std::vector<std::string> arguments() const {
        std::vector<std::string> words{"sensitivity", "--over=" + over, "--better=" + better_directions()};
        for (const std::string& output : outputs) words.push_back("--output=" + output);
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        for (const std::string& metric : metrics) words.push_back("--metric=" + metric);
        if (csv) words.emplace_back("--csv");
        if (markdown) words.emplace_back("--markdown");
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_sensitivity(CLI::App& app, Program& program) {
    auto options = std::make_shared<SensitivityOptions>();
    CLI::App* command =
        app.add_subcommand("sensitivity", "Draw what one condition, such as the speed, changes");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command->add_option("--over", options->over, "COLUMN: the condition that is along x")->required();
    command
        ->add_option("-o,--output", options->outputs,
                     "picture, .svg or .png; may be given several times for the same in several files")
        ->required()
        ->allow_extra_args(false);
    command
        ->add_option("--only", options->filters,
                     "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--metric", options->metrics,
            "a column, a metric for all its columns, or a quotient of two columns, A/B; may be given "
            "several times")
        ->allow_extra_args(false);
    CLI::Option* csv =
        command->add_flag("--csv", options->csv, "print what is drawn, comma-separated, in full precision");
    command->add_flag("--markdown", options->markdown, "print what is drawn as a Markdown table")
        ->excludes(csv);
    command->callback([options, &program] { program.exit_code = run_analysis(options->arguments()); });
}

}  // namespace trocar
