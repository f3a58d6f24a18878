#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace trocar {

/// Goes through the text of a mesh file line by line and word by word, and knows where it is when something
/// is wrong. Blank lines and everything from a # to the end of its line are skipped; a line may end in CR LF.
class MeshScanner {
  public:
    static constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

    /// @param file as it is named in messages
    /// @param text of the file; it must outlive the scanner
    MeshScanner(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

    /// Goes to the next line that has a word. False, and nothing moves, when there is none.
    bool next_line();

    [[nodiscard]] bool line_has_more() const;
    /// The next word of the line; fails, saying what was expected, when the line ends here.
    std::string_view word(std::string_view expected);
    /// The next three words as finite coordinates.
    void position();
    /// The next word, or its part before a slash, as a whole number in [low, high].
    std::int64_t integer(std::string_view expected, std::int64_t low = 0, std::int64_t high = unlimited);

    /// Throws MeshError at the word read last.
    [[noreturn]] void fail(std::string_view message) const;
    [[noreturn]] void fail_expected(std::string_view expected) const;
    /// Throws MeshError for a file that ends where something is `expected`.
    [[noreturn]] void fail_at_end(std::string_view expected) const;

    /// This line, without comment.
    [[nodiscard]] std::string_view line() const { return line_; }
    /// The text after it.
    [[nodiscard]] std::string_view rest() const { return rest_; }

  private:
    std::string file_;
    std::string_view rest_;       // the lines after this one
    std::string_view line_;       // this one, without comment
    std::string_view line_rest_;  // its words not yet read
    std::string_view word_;       // the word read last; empty where the line ended
    std::size_t line_number_ = 0;
};

}  // namespace trocar
