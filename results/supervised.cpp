#include "results/supervised.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/process/child.h"
#include "results/hdf5_handles.h"

namespace trocar {
namespace {

constexpr int patience_s = 120;
constexpr rlim_t base_seconds = 2;              // of the processor
constexpr rlim_t bytes_per_second = 1U << 20U;  // of the files: a fiftieth of what it reads
constexpr rlim_t base_memory = rlim_t{512} << 20U;
constexpr rlim_t memory_per_byte = 8;  // of the files: texts and figures are stored compressed
#ifdef __SANITIZE_ADDRESS__
constexpr bool memory_is_limited = false;  // AddressSanitizer reserves terabytes
#else
constexpr bool memory_is_limited = true;
#endif

/// The letters of the child's messages.
enum class Kind : char { reading = 'f', result = 'r', refused = 'e', failed = 'x' };

/// Where the child writes; the parent and unsupervised processes have none.
int& line_to_parent() {
    static int line = -1;
    return line;
}

void tell_parent(Kind kind, std::string_view text) {
    const bool heard = send_message(line_to_parent(), static_cast<char>(kind), text);
    if (!heard) _exit(EXIT_FAILURE);
}

/// What this process has reserved, bytes.
rlim_t reserved_memory() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource resource, rlim_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    now.rlim_cur = std::min(most, now.rlim_max);
    setrlimit(resource, &now);
}

rlim_t size_of(std::span<const std::filesystem::path> files) {
    rlim_t sum = 0;
    for (const auto& file : files) {
        std::error_code none;
        const std::uintmax_t size = std::filesystem::file_size(file, none);
        if (!none) sum += size;
    }
    return sum;
}

void run_child(std::span<const std::filesystem::path> files, const std::function<std::string()>& read) {
    const rlim_t size = size_of(files);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, base_seconds + size / bytes_per_second);
    if (memory_is_limited) {
        limit(RLIMIT_AS, reserved_memory() + base_memory + memory_per_byte * size);
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);  // NOLINT(*-vararg): POSIX open
        if (nowhere >= 0)
            dup2(nowhere, STDERR_FILENO);  // what the C library says of a heap that was written over
    }
    try {
        tell_parent(Kind::result, read());
    } catch (const StoreError& error) {
        tell_parent(Kind::refused, error.what());
    } catch (const std::bad_alloc&) {
        tell_parent(Kind::failed, "it asks for more memory than its size explains");
    } catch (const std::exception& error) {
        tell_parent(Kind::failed, error.what());
    }
}

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view reason) {
    throw DamagedFile(fmt::format("{}: is damaged: {}", file.string(), reason));
}

/// What the child has said so far.
struct Heard {
    std::filesystem::path file;  ///< that it reads
    std::optional<std::string> result;
};

/// Throws StoreError when the child did.
void take(Message message, Heard& heard) {
    switch (static_cast<Kind>(message.letter)) {
        case Kind::reading:
            heard.file = message.text;
            return;
        case Kind::result:
            heard.result = std::move(message.text);
            return;
        case Kind::refused:
            throw StoreError(message.text);
        case Kind::failed:
            fail(heard.file, message.text);
    }
    fail(heard.file, "reading it ended in a muddle");
}

std::string listen_to(Child& child, Heard heard) {
    while (!child.closed()) {
        pollfd waiting{.fd = child.line(), .events = POLLIN, .revents = 0};
        const int ready = poll(&waiting, 1, 1000 * patience_s);
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) fail(heard.file, fmt::format("reading it came to a halt for {} s", patience_s));
        for (Message& message : child.messages()) take(std::move(message), heard);
    }
    const Ending ending = child.end();
    if (ending.signal == SIGXCPU) fail(heard.file, "reading it takes longer than its size explains");
    if (ending.signal != 0 || !heard.result)
        fail(heard.file, fmt::format("reading it ended with {}", ending.text));
    return std::move(*heard.result);
}

}  // namespace

std::string supervised(std::span<const std::filesystem::path> files,
                       const std::function<std::string()>& read) {
    const hdf5::Session session;  // no other thread is inside HDF5 when the child is made
    Child child([&](int line) {
        line_to_parent() = line;
        run_child(files, read);
    });
    return listen_to(child, {.file = files.empty() ? std::filesystem::path() : files.front(), .result = {}});
}

void now_reading(const std::filesystem::path& file) {
    if (line_to_parent() >= 0) tell_parent(Kind::reading, file.string());
}

void end_with_error(const std::string& message) {
    if (line_to_parent() < 0) return;
    tell_parent(Kind::refused, message);
    _exit(EXIT_SUCCESS);
}

std::string joined_texts(std::span<const std::string> texts) {
    std::string joined;
    for (const std::string& text : texts) joined += fmt::format("{}:{}", text.size(), text);
    return joined;
}

std::vector<std::string> split_texts(std::string_view joined) {
    std::vector<std::string> texts;
    while (!joined.empty()) {
        std::size_t length = 0;
        const auto [end, error] = std::from_chars(joined.data(), joined.data() + joined.size(), length);
        joined.remove_prefix(static_cast<std::size_t>(end - joined.data()));
        if (error != std::errc() || !joined.starts_with(':') || joined.size() - 1 < length)
            throw StoreError("a text from a child process is cut off");
        texts.emplace_back(joined.substr(1, length));
        joined.remove_prefix(1 + length);
    }
    return texts;
}

}  // namespace trocar
