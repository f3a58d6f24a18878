#include "experiments/cli/temporary_folder.h"

#include <string>
#include <system_error>

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include "experiments/input_error.h"

namespace trocar {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "trocar-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw InputError(fmt::format("cannot make a folder in {}", fs::temp_directory_path().string()));
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace trocar
