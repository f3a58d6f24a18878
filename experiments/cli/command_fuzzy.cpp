#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "experiments/cli/commands.h"
#include "experiments/cli/explain_case.h"
#include "experiments/cli/explain_numbers.h"
#include "experiments/cli/plot_rules.h"
#include "experiments/input_error.h"
#include "strategies/fuzzy/rules_option.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the "
    "analysis.\n"
    "Example:\n"
    "  trocar fuzzy rules > my.fll\n"
    "  trocar fuzzy explain --motion 0,0,-1 --normal 0,0,1 --normal 0.6,0,0.8 --option rules=my.fll\n"
    "  trocar fuzzy explain sweep.toml --only speed=400 --only seed=1 --step 3\n"
    "  trocar fuzzy plot -o plots";

constexpr const char* explain_footer =
    "Either a vertex of a case, which is run anew up to the step; or numbers: a motion and the normals of\n"
    "the facets around a vertex.\n"
    "Exit codes: 0 done; 2 bad usage or input: no such case, step or vertex.\n"
    "Example:\n"
    "  trocar fuzzy explain sweep.toml --case 3f2a --step 3 --vertex 345\n"
    "  trocar fuzzy explain --motion 0,0,-1 --normal 0.28,0,0.96 --normal -0.48,0.64,0.6";

struct ExplainOptions {
    ExplainCase of_case;
    ExplainNumbers of_numbers;
};

std::string explain(const ExplainOptions& options) {
    const bool from_case = !options.of_case.sweep_file.empty();
    const bool from_numbers = !options.of_numbers.motion.empty() || !options.of_numbers.normals.empty();
    if (from_case == from_numbers) {
        throw InputError(
            "explain needs either a sweep file, or --motion and --normal (see trocar fuzzy explain --help)");
    }
    if (from_case) return explain_case(options.of_case);
    if (options.of_numbers.motion.empty() || options.of_numbers.normals.empty()) {
        throw InputError("numbers are --motion x,y,z and --normal x,y,z, one for each facet");
    }
    return explain_numbers(options.of_numbers);
}

void add_rules(CLI::App& fuzzy, Program& program) {
    CLI::App* command = fuzzy.add_subcommand("rules", "Print the rule base that ships, to be changed");
    command->footer(footer);
    command->callback([&program] {
        fmt::print("{}", fuzzy::shipped_rules());
        program.exit_code = ExitCode::done;
    });
}

void add_explain(CLI::App& fuzzy, Program& program) {
    auto options = std::make_shared<ExplainOptions>();
    ExplainCase& of_case = options->of_case;
    ExplainNumbers& of_numbers = options->of_numbers;
    CLI::App* command = fuzzy.add_subcommand("explain", "Say how fuzzy-per-vertex comes to a direction");
    command->footer(explain_footer);
    command->add_option("SWEEP", of_case.sweep_file, "sweep file of the case");
    command->add_option("--case", of_case.case_id, "case id, or its beginning");
    command->add_option("--only", of_case.filters, "key=value, as of trocar run")->allow_extra_args(false);
    command->add_option("--step", of_case.step, "number from 0, as in a replay");
    command->add_option("--vertex", of_case.vertex, "number from 0; without it the deepest");
    command->add_option("--motion", of_numbers.motion, "v_m: x,y,z");
    command->add_option("--normal", of_numbers.normals, "outer normal of a facet: x,y,z; once for each facet")
        ->allow_extra_args(false);
    command
        ->add_option("--option", of_numbers.options,
                     "with numbers: key=value, an option of fuzzy-per-vertex; rules=FILE too")
        ->allow_extra_args(false);
    command->callback([options, &program] {
        fmt::print("{}", explain(*options));
        program.exit_code = ExitCode::done;
    });
}

void add_plot(CLI::App& fuzzy, Program& program) {
    struct PlotOptions {
        std::string rules = fuzzy::shipped_rules_name, folder;
    };
    auto options = std::make_shared<PlotOptions>();
    CLI::App* command = fuzzy.add_subcommand(
        "plot", "Draw the membership functions (Fig. 2) and the weights over I_C, as SVG and PNG");
    command->footer(footer);
    command->add_option("RULES", options->rules, "rule base in FLL, or feedback, the one that ships")
        ->capture_default_str();
    command->add_option("-o,--output", options->folder, "folder to write into")->required();
    command->callback(
        [options, &program] { program.exit_code = plot_rules(options->rules, options->folder); });
}

}  // namespace

void add_fuzzy(CLI::App& app, Program& program) {
    CLI::App* command =
        app.add_subcommand("fuzzy", "Look into the paper's method: its rules, a vertex, plots");
    command->footer(footer);
    command->require_subcommand(1);
    add_rules(*command, program);
    add_explain(*command, program);
    add_plot(*command, program);
}

}  // namespace trocar
