#include <algorithm>

#include "experiments/input_error.h"
#include "experiments/run/build_info.h"
#include "experiments/run/git_stamp.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

constexpr std::string_view dirty = " dirty";  // as long as " clean"

/// The program's bytes, with spaces wherever it says which commit it is of.
std::string bytes_without_stamp() {
    std::string bytes = read_bytes("/proc/self/exe");
    std::size_t found = bytes.find(git_stamp);
    if (found == std::string::npos) {
        throw InputError(
            "the program's file does not hold the commit that the program was built from: it was packed, or "
            "replaced since the start; start the program as it was built");
    }
    for (; found != std::string::npos; found = bytes.find(git_stamp, found)) {
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(found), git_stamp.size(), ' ');
    }
    return bytes;
}

}  // namespace

std::string_view git_commit() {
    const std::string_view before = git_stamp.substr(0, git_stamp.size() - dirty.size());
    const std::string_view padded = before.substr(before.find("commit ") + 7);
    return padded.substr(0, padded.find(' '));
}

bool git_dirty() { return git_stamp.ends_with(dirty); }

std::string build_id() {
    static const std::string id = hash_of(bytes_without_stamp());
    return id;
}

}  // namespace trocar
