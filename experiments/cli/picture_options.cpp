#include "experiments/cli/picture_options.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "experiments/cli/better_directions.h"

namespace trocar {

std::vector<std::string> PictureOptions::words(std::vector<std::string> command) const {
    command.push_back("--better=" + better_directions());
    for (const std::string& output : outputs) command.push_back("--output=" + output);
    for (const std::string& filter : filters) command.push_back("--only=" + filter);
    if (csv) command.emplace_back("--csv");
    if (markdown) command.emplace_back("--markdown");
    command.insert(command.end(), {"--", file});
    return command;
}

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command.add_option("RESULTS", options.file, "result file that trocar run wrote")->required();
    command
        .add_option("-o,--output", options.outputs,
                    "picture, .svg or .png; may be given several times for the same in several files")
        ->required()
        ->allow_extra_args(false);
    command
        .add_option("--only", options.filters,
                    "key=value: these cases only, as for trocar run; may be given several times")
        ->allow_extra_args(false);
    CLI::Option* csv =
        command.add_flag("--csv", options.csv, "print what is drawn, comma-separated, in full precision");
    command.add_flag("--markdown", options.markdown, "print what is drawn as a Markdown table")
        ->excludes(csv);
}

}  // namespace trocar
