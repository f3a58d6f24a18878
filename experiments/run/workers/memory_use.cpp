#include "experiments/run/workers/memory_use.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace trocar {
namespace {

/// The sum of the entries of these names in a file of lines "NAME: NUMBER kB", bytes. None where it has none
/// of them.
std::optional<std::uint64_t> sum_of(const std::string& file, std::span<const std::string_view> names) {
    std::ifstream stream(file);
    std::optional<std::uint64_t> sum;
    for (std::string line; std::getline(stream, line);) {
        const auto colon = line.find(':');
        if (colon == std::string::npos) continue;
        if (std::ranges::find(names, std::string_view(line).substr(0, colon)) == names.end()) continue;
        sum = sum.value_or(0) + 1024 * std::stoull(line.substr(colon + 1));
    }
    return sum;
}

}  // namespace

std::optional<std::uint64_t> memory_use(pid_t process) {
    static constexpr std::array<std::string_view, 2> names{"RssAnon", "VmSwap"};
    return sum_of(fmt::format("/proc/{}/status", process), names);
}

std::uint64_t available_memory() {
    static constexpr std::array<std::string_view, 1> names{"MemAvailable"};
    return sum_of("/proc/meminfo", names).value_or(0);
}

}  // namespace trocar
