#include "sweep_folder.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

namespace trocar {

const std::string small_sweep = R"(name = "small"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@12mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [400]
seeds = 2
)";

SweepFolder::SweepFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "trocar-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = name;
}

SweepFolder::~SweepFolder() { std::filesystem::remove_all(folder_); }

std::filesystem::path SweepFolder::write(std::string_view name, std::string_view text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

Sweep SweepFolder::read(std::string_view text) const { return read_sweep(write("sweep.toml", text)); }

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::invalid_argument("the text to replace is not there");
    return text.replace(at, from.size(), to);
}

}  // namespace trocar
