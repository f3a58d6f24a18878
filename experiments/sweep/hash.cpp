#include "experiments/sweep/hash.h"

#include <cerrno>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <xxhash.h>

#include "experiments/input_error.h"

namespace trocar {

std::string hash_of(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_of_file(const std::filesystem::path& file) { return hash_of(read_bytes(file)); }

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        throw InputError(fmt::format("{}: this is a folder, not a file", file.string()));
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(stream), {});
    if (!stream.is_open() || stream.bad()) {
        const std::string reason = errno != 0 ? std::generic_category().message(errno) : "cannot be read";
        throw InputError(fmt::format("{}: {}", file.string(), reason));
    }
    return bytes;
}

}  // namespace trocar
