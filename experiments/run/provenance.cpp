#include "experiments/run/provenance.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string_view>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/utsname.h>

#include "experiments/run/build_info.h"

namespace trocar {
namespace {

std::string first_line(const char* file) {
    std::ifstream stream(file);
    std::string line;
    return std::getline(stream, line) ? line : "unknown";
}

/// Processes ready to run, averaged over the last minute.
double load() {
    double average = 0;
    return getloadavg(&average, 1) == 1 ? average : std::numeric_limits<double>::quiet_NaN();
}

struct System {
    std::string kernel = "unknown", host = "unknown";
};

System system_names() {
    utsname names{};
    if (uname(&names) != 0) return {};
    return {.kernel = fmt::format("{} {} {}", names.sysname, names.release, names.machine),
            .host = names.nodename};
}

}  // namespace

std::string cpu_model() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string now_utc() {
    using std::chrono::floor, std::chrono::milliseconds, std::chrono::seconds, std::chrono::system_clock;
    const auto now = floor<milliseconds>(system_clock::now());
    const auto second = floor<seconds>(now);
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(second)),
                       (now - second).count());
}

std::vector<Cell> provenance_row(const std::string& case_id, std::span<const std::string> arguments,
                                 const std::string& start, const std::string& end) {
    const System system = system_names();
    const auto text = [](const char* name, const char* meaning, std::string_view value) {
        return Cell{name, "", meaning, std::string(value)};
    };
    return {
        text("case_id", "the case that this row is about", case_id),
        text("git_commit", "commit that the program was built from", git_commit()),
        {"git_dirty", "1", "1 when the tree had changes that the commit does not hold",
         std::int64_t{git_dirty() ? 1 : 0}},
        text("compiler", "compiler", compiler()),
        text("flags", "flags of the compiler", compiler_flags()),
        text("build_type", "CMake's build type", build_type()),
        text("libraries", "versions of the libraries", library_versions()),
        text("cpu", "model of the processor", cpu_model()),
        {"cores", "1", "threads that the machine runs at once",
         std::int64_t{std::thread::hardware_concurrency()}},
        text("governor", "frequency governor of the first core",
             first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")),
        {"load", "1", "processes ready to run, mean of the last minute", load()},
        text("kernel", "kernel and machine type", system.kernel),
        text("host", "name of the machine", system.host),
        text("argv", "command line", fmt::format("{}", fmt::join(arguments, " "))),
        text("start", "when the case started, UTC", start),
        text("end", "when the case ended, UTC", end),
    };
}

}  // namespace trocar
