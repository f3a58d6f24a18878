#include "results/supervised.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// What the child says through its pipe: one letter, the length of the text, the text.
enum class Kind : char { reading = 'f', result = 'r', refused = 'e', failed = 'x' };

struct MessageHead {
    Kind kind = Kind::failed;
    std::uint64_t length = 0;
};

/// Where the child writes; the parent and unsupervised processes have none.
int& child_pipe() {
    static int descriptor = -1;
    return descriptor;
}

void write_all(int descriptor, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = write(descriptor, bytes, count);
        if (written < 0 && errno != EINTR) _exit(EXIT_FAILURE);  // nobody listens
        if (written <= 0) continue;
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

void send(Kind kind, std::string_view text) {
    std::array<char, 1 + sizeof(std::uint64_t)> head{static_cast<char>(kind)};
    const std::uint64_t length = text.size();
    std::memcpy(&head[1], &length, sizeof length);
    write_all(child_pipe(), head.data(), head.size());
    write_all(child_pipe(), text.data(), text.size());
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

[[noreturn]] void run_child(std::span<const std::filesystem::path> files,
                            const std::function<std::string()>& read) {
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
        send(Kind::result, read());
    } catch (const StoreError& error) {
        send(Kind::refused, error.what());
    } catch (const std::bad_alloc&) {
        send(Kind::failed, "it asks for more memory than its size explains");
    } catch (const std::exception& error) {
        send(Kind::failed, error.what());
    }
    _exit(EXIT_SUCCESS);
}

/// A child process, killed and waited for at the end of its scope at the latest.
class Child {
  public:
    Child(pid_t process, int pipe) : process_(process), pipe_(pipe) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (process_ > 0) kill(process_, SIGKILL);
        wait();
        close(pipe_);
    }

    [[nodiscard]] int pipe() const { return pipe_; }

    /// @returns how it ended, as waitpid says it
    int wait() {
        int status = 0;
        if (process_ <= 0) return status;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return status;
    }

  private:
    pid_t process_;
    int pipe_;
};

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view reason) {
    throw DamagedFile(fmt::format("{}: is damaged: {}", file.string(), reason));
}

/// What was received so far, cut into messages.
class Inbox {
  public:
    explicit Inbox(std::filesystem::path first_file) : file_(std::move(first_file)) {}

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] bool has_result() const { return has_result_; }
    std::string take_result() { return std::move(result_); }

    /// Throws StoreError when the child did.
    void append(std::string_view bytes) {
        bytes_ += bytes;
        std::size_t start = 0;
        constexpr std::size_t head_size = 1 + sizeof(std::uint64_t);
        while (bytes_.size() - start >= head_size) {
            MessageHead head{.kind = static_cast<Kind>(bytes_[start])};
            std::memcpy(&head.length, &bytes_[start + 1], sizeof head.length);
            if (bytes_.size() - start - head_size < head.length) break;
            receive(head.kind, bytes_.substr(start + head_size, head.length));
            start += head_size + head.length;
        }
        bytes_.erase(0, start);
    }

  private:
    void receive(Kind kind, std::string text) {
        switch (kind) {
            case Kind::reading:
                file_ = text;
                return;
            case Kind::result:
                result_ = std::move(text);
                has_result_ = true;
                return;
            case Kind::refused:
                throw StoreError(text);
            case Kind::failed:
                fail(file_, text);
        }
        fail(file_, "reading it ended in a muddle");
    }

    std::string bytes_;
    std::filesystem::path file_;
    std::string result_;
    bool has_result_ = false;
};

std::string listen_to(Child& child, Inbox& inbox) {
    std::array<char, 1U << 16U> buffer{};
    while (true) {
        pollfd waiting{.fd = child.pipe(), .events = POLLIN, .revents = 0};
        const int ready = poll(&waiting, 1, 1000 * patience_s);
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0) fail(inbox.file(), fmt::format("reading it came to a halt for {} s", patience_s));
        const ssize_t count = read(child.pipe(), buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        inbox.append({buffer.data(), static_cast<std::size_t>(count)});
    }
    const int status = child.wait();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        fail(inbox.file(), "reading it takes longer than its size explains");
    if (WIFSIGNALED(status)) {
        fail(inbox.file(), fmt::format("reading it ended with signal {} ({})", WTERMSIG(status),
                                       strsignal(WTERMSIG(status))));
    }
    if (!inbox.has_result()) {
        fail(inbox.file(), fmt::format("reading it ended with exit code {}", WEXITSTATUS(status)));
    }
    return inbox.take_result();
}

}  // namespace

std::string supervised(std::span<const std::filesystem::path> files,
                       const std::function<std::string()>& read) {
    const hdf5::Session session;  // no other thread is inside HDF5 when the child is made
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw std::system_error(errno, std::generic_category(), "making a pipe");
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0) {
        const int error = errno;
        for (const int end : ends) close(end);
        throw std::system_error(error, std::generic_category(), "starting a process");
    }
    if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // NOLINT(*-vararg): without its parent nobody needs the answer
        if (getppid() != parent) _exit(EXIT_FAILURE);
        close(ends[0]);
        child_pipe() = ends[1];
        run_child(files, read);
    }
    close(ends[1]);
    Child child(process, ends[0]);
    Inbox inbox(files.empty() ? std::filesystem::path() : files.front());
    return listen_to(child, inbox);
}

void now_reading(const std::filesystem::path& file) {
    if (child_pipe() >= 0) send(Kind::reading, file.string());
}

void end_with_error(const std::string& message) {
    if (child_pipe() < 0) return;
    send(Kind::refused, message);
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
