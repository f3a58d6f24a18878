#include "experiments/run/origins.h"

#include <map>

#include <fmt/format.h>

namespace trocar {
namespace {

constexpr std::size_t shown_digits = 12;  // of a build_id

using Counts = std::map<std::string, std::size_t>;  // origin → cases

void add_line(const Counts& counts, const char* what, std::vector<std::string>& lines) {
    if (counts.size() < 2) return;
    std::string list;
    for (const auto& [origin, cases] : counts)
        list += fmt::format("{}{} of {}", list.empty() ? "" : ", ", cases, origin);
    lines.push_back(fmt::format("warning: the cases come from {} {} ({}): their times are not comparable",
                                counts.size(), what, list));
}

}  // namespace

std::vector<std::string> mixed_origins(std::span<const Contents::Case> cases) {
    Counts programs, machines;
    for (const Contents::Case& one : cases) {
        ++programs[one.build_id.substr(0, shown_digits)];
        ++machines[one.machine];
    }
    std::vector<std::string> lines;
    add_line(programs, "programs", lines);
    add_line(machines, "machines", lines);
    return lines;
}

}  // namespace trocar
