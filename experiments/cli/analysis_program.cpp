#include "experiments/cli/analysis_program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "experiments/cli/shipped_files.h"
#include "experiments/input_error.h"

namespace trocar {
namespace {

// Debian's own: another python3 may come first in PATH, without Debian's packages.
constexpr const char* python = "/usr/bin/python3";

/// Whether a process ends with this signal by what it does itself, not by what others want.
bool is_crash(int signal) {
    constexpr std::array crashes{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};
    return std::ranges::find(crashes, signal) != crashes.end();
}

int wait_for(pid_t child, const std::vector<std::string>& arguments) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR)
            throw std::system_error(errno, std::generic_category(), "waiting for the analysis");
    }
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    const int signal = WTERMSIG(status);
    if (!is_crash(signal)) return 128 + signal;
    const auto marker = std::ranges::find(arguments, "--");
    throw InputError(
        fmt::format("{}: is damaged: reading it ended with signal {} ({}); run its sweep again",
                    fmt::join(marker == arguments.end() ? marker : marker + 1, arguments.end(), ", "), signal,
                    strsignal(signal)));
}

}  // namespace

int run_analysis(const std::vector<std::string>& arguments) {
    std::string path =
        find_shipped("analysis/trocar_analysis/__init__.py").parent_path().parent_path().string();
    if (const char* earlier = std::getenv("PYTHONPATH"); earlier != nullptr && *earlier != '\0') {
        path += fmt::format(":{}", earlier);
    }
    setenv("PYTHONPATH", path.c_str(), 1);

    std::vector<std::string> command{python, "-m", "trocar_analysis"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(command.size() + 1);
    for (std::string& word : command) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawn(&child, python, nullptr, nullptr, argv.data(), environ);
    if (error != 0) {
        throw InputError(fmt::format("cannot start {} ({}): the analysis needs the package python3", python,
                                     std::generic_category().message(error)));
    }
    return wait_for(child, arguments);
}

}  // namespace trocar
