#include "common/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace trocar {
namespace {

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);  // distances of one prefix of `from` to every prefix of `to`
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string_view nearest_name(std::string_view wrong, std::span<const std::string> names) {
    std::string_view nearest;
    std::size_t least = 0;
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(wrong, name);
        if (2 * distance > std::max(wrong.size(), name.size())) continue;
        if (nearest.empty() || distance < least) {
            nearest = name;
            least = distance;
        }
    }
    return nearest;
}

std::string unknown_name(std::string_view kind, std::string_view wrong, std::span<const std::string> names) {
    std::string sentence = "unknown ";
    sentence.append(kind).append(" \"").append(wrong).append("\"");
    if (const std::string_view nearest = nearest_name(wrong, names); !nearest.empty()) {
        sentence.append("; did you mean \"").append(nearest).append("\"?");
    } else {
        sentence += '.';
    }
    sentence += " Known: ";
    for (std::size_t i = 0; i < names.size(); ++i) sentence.append(i == 0 ? "" : ", ").append(names[i]);
    return sentence;
}

}  // namespace trocar
