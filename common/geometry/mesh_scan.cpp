#include "common/geometry/mesh_scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "common/geometry/mesh_error.h"

namespace trocar {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::size_t longest_quote = 40;  // characters of a strange word that a message repeats

std::string quoted(std::string_view word) {
    if (word.empty()) return "the end of the line";
    std::string text(word.substr(0, longest_quote));
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '?');
    return fmt::format("\"{}{}\"", text, word.size() > longest_quote ? "…" : "");
}

// from_chars knows no plus sign.
template <class Number>
bool parse(std::string_view word, Number& number) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.begin(), word.end(), number);
    return error == std::errc() && end == word.end();
}

}  // namespace

bool MeshScanner::next_line() {
    std::string_view rest = rest_;
    for (std::size_t number = line_number_ + 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(blanks) == std::string_view::npos) continue;
        rest_ = rest;
        line_ = line_rest_ = line;
        word_ = {};
        line_number_ = number;
        return true;
    }
    return false;
}

bool MeshScanner::line_has_more() const {
    return line_rest_.find_first_not_of(blanks) != std::string_view::npos;
}

std::string_view MeshScanner::word(std::string_view expected) {
    line_rest_.remove_prefix(std::min(line_rest_.find_first_not_of(blanks), line_rest_.size()));
    word_ = line_rest_.substr(0, line_rest_.find_first_of(blanks));
    if (word_.empty()) fail_expected(expected);
    line_rest_.remove_prefix(word_.size());
    return word_;
}

void MeshScanner::position() {
    for (const std::string_view expected : {"coordinate x, a finite number", "coordinate y, a finite number",
                                            "coordinate z, a finite number"}) {
        double number = 0;
        if (!parse(word(expected), number) || !std::isfinite(number)) fail_expected(expected);
    }
}

std::int64_t MeshScanner::integer(std::string_view expected, std::int64_t low, std::int64_t high) {
    const std::string_view text = word(expected);
    std::int64_t number = 0;
    if (!parse(text.substr(0, text.find('/')), number) || number < low || number > high) {
        if (high == unlimited) fail_expected(expected);
        fail_expected(fmt::format("{} from {} to {}", expected, low, high));
    }
    return number;
}

void MeshScanner::fail(std::string_view message) const {
    const auto column =
        (word_.empty() ? line_.size() : static_cast<std::size_t>(word_.data() - line_.data())) + 1;
    throw MeshError(fmt::format("{}:{}:{}: {}", file_, line_number_, column, message));
}

void MeshScanner::fail_expected(std::string_view expected) const {
    fail(fmt::format("expected {}, found {}", expected, quoted(word_)));
}

void MeshScanner::fail_at_end(std::string_view expected) const {
    throw MeshError(
        fmt::format("{}: expected {} after line {}, found the end of the file: it seems to be cut off", file_,
                    expected, line_number_));
}

}  // namespace trocar
