#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/better_directions.h"
#include "experiments/cli/commands.h"
#include "experiments/cli/shipped_files.h"
#include "experiments/turns/turns.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "One HTML file that a browser opens without a server or a network: the strategies ranked, the paper's "
    "claims\n"
    "as far as the file has their cases, charts that filters cut down, every case with its series, and, of "
    "runs\n"
    "with replays (trocar run --replay), strategies side by side in 3D. What does not fit in the budget is "
    "thinned\n"
    "or left out, and the page says so. Beside a file that trocar reproduce wrote, its .turns.csv is read "
    "too.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar report results.h5 -o report.html\n"
    "  trocar report results.h5 -o small.html --budget 5";

struct ReportOptions {
    std::string file, output;
    double budget = 15;

    [[nodiscard]] std::vector<std::string> words() const {
        std::vector<std::string> words{"report", "--output=" + output, fmt::format("--budget={}", budget),
                                       "--better=" + better_directions(),
                                       "--claims=" + find_shipped("experiments/claims.toml").string()};
        const std::filesystem::path turns = turns_beside(file);
        if (std::filesystem::exists(turns)) words.push_back("--turns=" + turns.string());
        words.insert(words.end(), {"--", file});
        return words;
    }
};

}  // namespace

void add_report(CLI::App& app, Program& program) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command =
        app.add_subcommand("report", "Make one HTML page of a result file, with its replays in 3D");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file that trocar run wrote")->required();
    command->add_option("-o,--output", options->output, "page to write, .html")->required();
    command->add_option("--budget", options->budget, "largest size of the page, MB")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->callback([options, &program] { program.exit_code = run_analysis(options->words()); });
}

}  // namespace trocar
