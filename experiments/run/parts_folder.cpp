#include "experiments/run/parts_folder.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "experiments/input_error.h"
#include "experiments/run/done_cases.h"
#include "results/pending_file.h"

namespace trocar {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& out, const std::error_code& reason) {
    throw InputError(
        fmt::format("{}: cannot be written ({}); choose another output", out.string(), reason.message()));
}

}  // namespace

PartsFolder::PartsFolder(const std::filesystem::path& out, PartsOf run)
    : folder_(parts_folder_of(std::filesystem::absolute(out))),
      own_(run == PartsOf::fresh_run ? fresh_parts_folder_of(std::filesystem::absolute(out)) : folder_) {
    std::error_code error;
    std::filesystem::create_directory(folder_, error);
    if (error) refuse(out, error);
    if (access(folder_.c_str(), W_OK | X_OK) != 0 ||
        access(folder_.parent_path().c_str(), W_OK | X_OK) != 0) {
        refuse(out, {errno, std::generic_category()});
    }
    lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0) refuse(out, {errno, std::generic_category()});
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        close(lock_);
        throw InputError(
            fmt::format("{}: another run is writing it; wait for that run to end", out.string()));
    }
    std::filesystem::create_directory(own_, error);
    if (error) {
        close(lock_);
        refuse(out, error);
    }
    remove_abandoned(folder_.parent_path(), out.filename().string());
    remove_abandoned(own_, "");
}

PartsFolder::~PartsFolder() {
    remove_abandoned(own_, "");  // a worker that was ended while it wrote keeps its place on a full disk
    std::error_code not_empty;
    std::filesystem::remove(own_, not_empty);
    std::filesystem::remove(folder_, not_empty);
    close(lock_);
}

void PartsFolder::clear() const {
    std::error_code gone;  // what is left is found to be done by the next run
    for (const auto& folder : {folder_, own_}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder, gone)) {
            if (entry.path().extension() == ".h5") std::filesystem::remove(entry, gone);
        }
    }
}

}  // namespace trocar
