#include "results/pending_file.h"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "results/store.h"

namespace trocar {
namespace {

std::string host_name() {
    std::array<char, 256> name{};
    // The last byte stays zero: a name that is cut off need not be terminated.
    if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
    return name.data();
}

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error) {
    throw StoreError(
        fmt::format("{}: {}: {}", path.string(), action, std::generic_category().message(error)));
}

/// Makes what was written to a file, or the names in a folder, survive a power failure.
void sync(const std::filesystem::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);  // NOLINT(*-vararg): POSIX open
    if (descriptor < 0) fail(path, "cannot open it to bring it to the disk", errno);
    const int error = fsync(descriptor) == 0 ? 0 : errno;
    close(descriptor);
    if (error != 0) fail(path, "cannot bring it to the disk", error);
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path name) : name_(std::move(name)), temporary_(name_) {
    temporary_ += fmt::format(".tmp.{}.{}", host_name(), getpid());
}

PendingFile::~PendingFile() {
    std::error_code ignored;  // there may be nothing to remove
    // A file that HDF5 could not close keeps its place on a full disk after it is removed, unless it is
    // empty.
    std::filesystem::resize_file(temporary_, 0, ignored);
    std::filesystem::remove(temporary_, ignored);
}

void remove_abandoned(const std::filesystem::path& folder, const std::string& name) {
    const std::string suffix = fmt::format(".tmp.{}.", host_name());
    std::error_code ignored;  // nothing depends on it
    for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, ignored)) {
        const std::string file = entry.path().filename().string();
        const bool of_name = name.empty() || file.starts_with(name + suffix);
        if (of_name && file.find(suffix) != std::string::npos) std::filesystem::remove(entry.path(), ignored);
    }
}

void PendingFile::publish() {
    sync(temporary_);
    std::error_code error;
    std::filesystem::rename(temporary_, name_, error);
    if (error) fail(name_, "cannot give the finished file its name", error.value());
    const auto folder = name_.parent_path();
    sync(folder.empty() ? "." : folder);
}

}  // namespace trocar
