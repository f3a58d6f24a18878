#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/better_directions.h"
#include "experiments/cli/commands.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Conditions of --fail-on: a figure, one of > < >= <=, and a number: a bound on the median of the paired\n"
    "differences B - A, in the figure's unit (times: ns), or with % in percent of the median of A. It is\n"
    "checked in every group that A has. The condition outcomes: a case that completed in A did not in B, or\n"
    "is missing there. A failed case counts as the worst value there is, and is listed.\n"
    "Exit codes: 0 done; 1 a condition of --fail-on is met; 2 bad usage or input, a condition that cannot "
    "be\n"
    "evaluated (no pairs, times of different machines), or a Python package is missing; 3 a bug of the "
    "analysis.\n"
    "Example:\n"
    "  trocar compare before.h5 after.h5 --metric depth_max --metric drag_mean --by label,speed\n"
    "  trocar compare before.h5 after.h5 --only label=mine --fail-on \"depth_max_d_max > +5%\" --fail-on "
    "outcomes";

struct CompareOptions {
    std::string before, after, by;
    std::vector<std::string> filters, metrics, conditions;
    bool csv = false, markdown = false;

    [[nodiscard]] std::vector<std::string> arguments() const {
        std::vector<std::string> words{"compare", "--better=" + better_directions()};
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        if (!by.empty()) words.push_back("--by=" + by);
        for (const std::string& metric : metrics) words.push_back("--metric=" + metric);
        for (const std::string& condition : conditions) words.push_back("--fail-on=" + condition);
        if (csv) words.emplace_back("--csv");
        if (markdown) words.emplace_back("--markdown");
        words.insert(words.end(), {"--", before, after});
        return words;
    }
};

}  // namespace

void add_compare(CLI::App& app, Program& program) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command =
        app.add_subcommand("compare", "Say what changed from one result file to another, case by case");
    command->footer(footer);
    command->add_option("A", options->before, "result file to compare with")->required();
    command
        ->add_option("B", options->after,
                     "result file of the same sweep, run with a changed strategy for example")
        ->required();
    command
        ->add_option("--only", options->filters,
                     "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    command->add_option(
        "--by", options->by,
        "inputs or options of strategies to group by, separated by commas; without it: label");
    command
        ->add_option("--metric", options->metrics,
                     "a column, or a metric for all its columns; may be given several times")
        ->allow_extra_args(false);
    command
        ->add_option("--fail-on", options->conditions,
                     "end with exit code 1 where this holds (see below); may be given several times")
        ->allow_extra_args(false);
    CLI::Option* csv = command->add_flag("--csv", options->csv, "comma-separated, in full precision");
    command->add_flag("--markdown", options->markdown, "a Markdown table")->excludes(csv);
    command->callback([options, &program] { program.exit_code = run_analysis(options->arguments()); });
}

}  // namespace trocar
