#include "experiments/cli/shipped_files.h"

#include <fmt/format.h>

#include "experiments/input_error.h"

namespace trocar {

namespace fs = std::filesystem;

fs::path find_shipped(const fs::path& relative) {
    const fs::path program = fs::read_symlink("/proc/self/exe");
    fs::path installed = program.parent_path().parent_path() / "share" / "trocar" / relative;
    if (fs::exists(installed)) return installed;
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
        if (fs::exists(folder / relative)) return folder / relative;
    }
    throw InputError(
        fmt::format("{} is neither {} nor in a folder above {}; build inside the source tree, or install",
                    relative.string(), installed.string(), program.string()));
}

}  // namespace trocar
