#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace trocar {

/// What the commands have in common that draw a result file's figures and print them: rank, front,
/// sensitivity.
struct PictureOptions {
    std::string file;
    std::vector<std::string> outputs, filters;
    bool csv = false, markdown = false;

    /// The analysis' command line: the command, its own words and these.
    [[nodiscard]] std::vector<std::string> words(std::vector<std::string> command) const;
};

/// Adds them to a command.
void add_picture_options(CLI::App& command, PictureOptions& options);

}  // namespace trocar
