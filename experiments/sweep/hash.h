#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trocar {

/// 128-bit XXH3 of the bytes, as 32 hexadecimal digits.
std::string hash_of(std::string_view bytes);

/// The same of a file's bytes. Throws InputError when it cannot be read.
std::string hash_of_file(const std::filesystem::path& file);

/// All bytes of a file. Throws InputError, naming the file and the system's reason, when it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

}  // namespace trocar
