#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::fuzzy {

/// A line `key: value` of a rule base, without its comment.
struct Statement {
    std::size_t line;  ///< of the text, from 1
    std::string key, value;
};

/// A variable or a block of rules: the statement that opens it, and those until the next one.
struct Block {
    Statement opening;  ///< its value is the name
    std::vector<Statement> statements;
};

/// The blocks of a rule base, `Engine` among them. Throws RuleError for a line that is no statement and for a
/// statement before the first block.
std::vector<Block> blocks_of(std::string_view text);

}  // namespace trocar::fuzzy
