#include "experiments/sweep/option_file.h"

#include <fmt/format.h>

#include "experiments/input_error.h"
#include "experiments/sweep/hash.h"

namespace trocar {

std::string read_option_file(const OptionSpec& option, const std::filesystem::path& file) {
    std::string contents = read_bytes(file);
    try {
        option.check_contents(contents);
    } catch (const ContentsError& error) {
        throw InputError(fmt::format("{}:{}: {}", file.string(), error.line, error.what()));
    }
    return contents;
}

}  // namespace trocar
