#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace trocar {

/// A value of an option, as it stands in a sweep file.
using OptionValue = std::variant<bool, double, std::string>;

/// Option name → value.
using Options = std::map<std::string, OptionValue>;

/// The contents of a file that an option was given cannot be used. The message says what was expected, what
/// was found and what to do.
struct ContentsError : std::runtime_error {
    ContentsError(std::size_t at, const std::string& message) : std::runtime_error(message), line(at) {}
    std::size_t line;  ///< of the contents, from 1
};

/// One option of a strategy. The kind of `default_value` is the option's kind.
struct OptionSpec {
    std::string name;
    OptionValue default_value;
    std::string summary;               ///< one line, with the unit of a number
    std::vector<std::string> choices;  ///< the words allowed; for text options
    double low = 0, high = 0;          ///< the range allowed, both ends included; for numbers
    /// Of a text option that takes, besides its choices, what a file holds (a sweep names the file; the
    /// option's value is the contents): throws ContentsError for contents that cannot be used.
    void (*check_contents)(const std::string& contents) = nullptr;
};

/// An option that does not exist or has a value that is not allowed. `option` is the name it was given under.
struct OptionError : std::invalid_argument {
    OptionError(std::string option_name, const std::string& message)
        : std::invalid_argument(message), option(std::move(option_name)) {}
    std::string option;
};

/// The defaults of `specs` with `given` laid over them. Throws OptionError, naming the nearest right word,
/// for a name that is not in `specs`, a value of another kind, a word that is not a choice, contents that
/// cannot be used, a number out of range.
Options resolve_options(const std::vector<OptionSpec>& specs, const Options& given);

/// @{
/// The value of a flag, number or word of resolved options.
bool flag(const Options& options, const std::string& name);
double number(const Options& options, const std::string& name);
const std::string& word(const Options& options, const std::string& name);
/// @}

}  // namespace trocar
