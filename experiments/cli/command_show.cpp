#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the "
    "analysis.\n"
    "Example:\n"
    "  trocar show results.h5 --by label,speed --metric depth_max_d_max\n"
    "  trocar show results.h5 --by aggregate,normals --only feedback=true\n"
    "  trocar show results.h5 --states --only run_label=nearest-face\n"
    "  trocar show results.h5 --failures --only organ=liver@4mm";

struct ShowOptions {
    std::string file, by;
    std::vector<std::string> filters, metrics;
    bool states = false, each = false, failures = false, provenance = false, csv = false, markdown = false;

    [[nodiscard]] std::vector<std::string> arguments() const {
        std::vector<std::string> words{"show"};
        for (const std::string& filter : filters) words.push_back("--only=" + filter);
        if (!by.empty()) words.push_back("--by=" + by);
        for (const std::string& metric : metrics) words.push_back("--metric=" + metric);
        if (states) words.emplace_back("--states");
        if (each) words.emplace_back("--each");
        if (failures) words.emplace_back("--failures");
        if (provenance) words.emplace_back("--provenance");
        if (csv) words.emplace_back("--csv");
        if (markdown) words.emplace_back("--markdown");
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_show(CLI::App& app, Program& program) {
    auto options = std::make_shared<ShowOptions>();
    CLI::App* command = app.add_subcommand("show", "Show the figures of a result file as a table");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command
        ->add_option("--only", options->filters,
                     "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    CLI::Option* states = command->add_flag(
        "--states", options->states,
        "the same-state comparison: what each strategy made of states found in the runs; label is "
        "the strategy that answered, run_label the one whose run it was");
    CLI::Option* by =
        command->add_option("--by", options->by,
                            "columns or options of strategies to group by, separated by commas; without it: "
                            "what differs, and the label");
    CLI::Option* metric =
        command
            ->add_option("--metric", options->metrics,
                         "a column, or a metric for all its columns; may be given several times")
            ->allow_extra_args(false);
    CLI::Option* failures = command->add_flag("--failures", options->failures,
                                              "the cases that did not complete, one a line, with the reason");
    CLI::Option* provenance = command->add_flag("--provenance", options->provenance,
                                                "which programs on which machines the cases come from");
    failures->excludes(states)->excludes(by)->excludes(metric);
    provenance->excludes(states)->excludes(by)->excludes(metric)->excludes(failures);
    command
        ->add_flag("--each", options->each,
                   "one row per case, as CSV in full precision: what it was run with, and its figures")
        ->excludes(states)
        ->excludes(by)
        ->excludes(failures)
        ->excludes(provenance);
    CLI::Option* csv = command->add_flag("--csv", options->csv, "comma-separated, in full precision");
    command->add_flag("--markdown", options->markdown, "a Markdown table")->excludes(csv);
    command->callback([options, &program] { program.exit_code = run_analysis(options->arguments()); });
}

}  // namespace trocar
