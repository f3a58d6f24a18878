#include "strategies/fuzzy/statements.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "strategies/fuzzy/read_rules.h"

namespace trocar::fuzzy {
namespace {

constexpr std::array<std::string_view, 4> openings = {"Engine", "InputVariable", "OutputVariable",
                                                      "RuleBlock"};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Statement statement_of(std::string_view line, std::size_t number) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) {
        throw RuleError(number,
                        fmt::format("a line must be \"key: value\", but this one has no colon: {}", line));
    }
    return {.line = number,
            .key = std::string(trimmed(line.substr(0, colon))),
            .value = std::string(trimmed(line.substr(colon + 1)))};
}

}  // namespace

std::vector<Block> blocks_of(std::string_view text) {
    std::vector<Block> blocks;
    std::size_t number = 0;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        line = trimmed(line.substr(0, line.find('#')));
        if (line.empty()) continue;
        Statement statement = statement_of(line, number);
        if (std::ranges::find(openings, statement.key) != openings.end()) {
            blocks.push_back({.opening = std::move(statement), .statements = {}});
        } else if (blocks.empty()) {
            throw RuleError(number, fmt::format("\"{}:\" stands before the first block; a rule base begins "
                                                "with \"Engine: NAME\"",
                                                statement.key));
        } else {
            blocks.back().statements.push_back(std::move(statement));
        }
    }
    return blocks;
}

}  // namespace trocar::fuzzy
