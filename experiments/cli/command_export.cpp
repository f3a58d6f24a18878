#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/analysis_program.h"
#include "experiments/cli/commands.h"
#include "results/store.h"
#include "results/xdmf.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "The organ and the tool of every step of a case that has a replay (trocar run --replay), as files for "
    "other\n"
    "programs, in mm: OBJ and PLY for Blender and MeshLab; VTP, with what the strategy did at each vertex, "
    "and a\n"
    ".pvd that gives the steps their times, for ParaView and VTK. replay.xdmf shows the same out of the "
    "result\n"
    "file itself, without copies. case.json says what the case is. An earlier export in the same folder is "
    "replaced;\n"
    "a folder with anything else in it is left alone.\n"
    "Exit codes: 0 done; 2 bad usage or input, or a Python package is missing; 3 a bug of the analysis.\n"
    "Example:\n"
    "  trocar export results.h5 --case 3f2a -o case\n"
    "  trocar export results.h5 --case 3f2a -o case --format vtp --moment handled --steps 10:20";

struct ExportOptions {
    std::string file, case_id, output, steps;
    std::vector<std::string> formats, moments;

    [[nodiscard]] std::vector<std::string> words() const {
        std::vector<std::string> words{"export", "--case=" + case_id, "--output=" + output};
        for (const std::string& format : formats) words.push_back("--format=" + format);
        for (const std::string& moment : moments) words.push_back("--moment=" + moment);
        if (!steps.empty()) words.push_back("--steps=" + steps);
        words.insert(words.end(), {"--", file});
        return words;
    }
};

/// The analysis has found the one case that is meant, and exported it.
int export_case(const ExportOptions& options) {
    if (const int code = run_analysis(options.words()); code != ExitCode::done) return code;
    const std::vector<Contents::Case> cases = read_contents(options.file).cases;
    const auto chosen = std::ranges::find_if(
        cases, [&](const Contents::Case& one) { return one.case_id.starts_with(options.case_id); });
    write_xdmf(options.file, std::filesystem::path(options.output) / "replay.xdmf", chosen->case_id);
    return ExitCode::done;
}

}  // namespace

void add_export(CLI::App& app, Program& program) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command =
        app.add_subcommand("export", "Write a recorded case as meshes for ParaView, Blender and others");
    command->footer(footer);
    command->add_option("RESULTS", options->file, "result file of a run with --replay")->required();
    command->add_option("--case", options->case_id, "case id, or its beginning where only one begins so")
        ->required();
    command->add_option("-o,--output", options->output, "folder, made where it is missing")->required();
    command
        ->add_option("--format", options->formats,
                     "obj, ply or vtp; may be given several times; without it all")
        ->check(CLI::IsMember({"obj", "ply", "vtp"}))
        ->allow_extra_args(false);
    command
        ->add_option("--moment", options->moments,
                     "of the organ: found, handled or deformed; may be given several times; without it "
                     "deformed")
        ->check(CLI::IsMember({"found", "handled", "deformed"}))
        ->allow_extra_args(false);
    command->add_option("--steps", options->steps,
                        "A:B: from step A to before step B, from 0, either may be left out; without it all");
    command->callback([options, &program] { program.exit_code = export_case(*options); });
}

}  // namespace trocar
