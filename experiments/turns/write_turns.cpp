#include <fstream>

#include <fmt/format.h>

#include "experiments/turns/turns.h"
#include "results/pending_file.h"
#include "results/store.h"

namespace trocar {
namespace {

/// As a field of CSV (RFC 4180).
std::string quoted(const std::string& text) {
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + '"';
}

}  // namespace

void write_turns(const std::filesystem::path& file, const std::vector<Turns>& rows) {
    PendingFile pending(file);
    std::ofstream out(pending.temporary());
    out << "label,seed,largest_turn,at,largest_turn_with_weak,weak,largest_turn_at_switch,inputs\n";
    for (const Turns& row : rows) {
        out << fmt::format("{},{},{:.17g},{:.17g},{:.17g},{},{:.17g},{}\n", quoted(row.label), row.seed,
                           row.largest_turn, row.at, row.largest_turn_with_weak, row.weak,
                           row.largest_turn_at_switch, row.inputs);
    }
    out.close();
    if (!out) throw StoreError(fmt::format("{}: cannot be written", file.string()));
    pending.publish();
}

std::filesystem::path turns_beside(const std::filesystem::path& results) {
    return std::filesystem::path(results).replace_extension(".turns.csv");
}

}  // namespace trocar
