#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/picture_options.h"

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

struct SensitivityOptions : PictureOptions {
    std::string over;
    std::vector<std::string> metrics;

    [[nodiscard]] std::vector<std::string> own_words() const {
        std::vector<std::string> words{"sensitivity", "--over=" + over};
        for (const std::string& metric : metrics) words.push_back("--metric=" + metric);
        return words;
    }
};

}  // namespace

void add_sensitivity(CLI::App& app, Program& program) {
    auto options = std::make_shared<SensitivityOptions>();
    CLI::App* command =
        app.add_subcommand("sensitivity", "Draw what one condition, such as the speed, changes");
    command->footer(footer);
    add_picture_options(*command, *options);
    command->add_option("--over", options->over, "COLUMN: the condition that is along x")->required();
    command
        ->add_option(
            "--metric", options->metrics,
            "a column, a metric for all its columns, or a quotient of two columns, A/B; may be given "
            "several times")
        ->allow_extra_args(false);
    command->callback(
        [options, &program] { program.exit_code = run_analysis(options->words(options->own_words())); });
}

}  // namespace trocar
