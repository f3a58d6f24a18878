#include "experiments/run/workers/worker.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trocar {
namespace {

// A message: one of these, the length of the text (8 bytes), the text.
constexpr char done_tag = 'd', error_tag = 'e';
constexpr std::size_t header_size = 1 + sizeof(std::uint64_t);

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Sends all of it; false when nobody listens any more.
bool send_all(int line, const void* bytes, std::size_t size) {
    const char* next = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t count = send(line, next, size, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        next += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

/// Reads exactly that many bytes; false at the end of the line.
bool read_all(int descriptor, char* bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t count = read(descriptor, bytes, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

void report(int line, char tag, const std::string& text) {
    std::array<char, header_size> header{tag};
    const std::uint64_t length = text.size();
    std::memcpy(header.data() + 1, &length, sizeof(length));
    const bool heard =
        send_all(line, header.data(), header.size()) && send_all(line, text.data(), text.size());
    if (!heard) _exit(1);  // the supervisor is gone
}

/// Leaves a child nothing of its parent's but what it was copied with and its end of the line: no other
/// files and no locks on them, no signals that the parent waits for.
int cut_loose(pid_t parent, int line) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it died in between
    // Ctrl-C reaches every process of the terminal; the supervisor decides.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    constexpr int own = STDERR_FILENO + 1;
    if (line != own) dup2(line, own);
    close_range(own + 1, ~0U, 0);
    return own;
}

[[noreturn]] void live(const DoBatch& work, int line) {
    try {
        Batch batch;
        while (read_all(line, reinterpret_cast<char*>(&batch), sizeof(batch))) {
            work(batch, [&](const std::string& text) { report(line, done_tag, text); });
        }
    } catch (const std::exception& error) {
        report(line, error_tag, error.what());
    } catch (...) {
        report(line, error_tag, "something that is no std::exception was thrown");
    }
    _exit(0);  // not exit: what the parent has registered for its own end is not ours
}

}  // namespace

Worker::Worker(const DoBatch& work) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) fail("fork");
    if (process_ == 0) live(work, cut_loose(parent, ends[1]));
    close(ends[1]);
    line_ = ends[0];
    fcntl(line_, F_SETFL, O_NONBLOCK);
}

Worker::~Worker() {
    end();
    close(line_);
}

void Worker::give(const Batch& batch) {
    // One that has died is noticed where it is listened to.
    (void)send_all(line_, &batch, sizeof(batch));
}

std::vector<WorkerMessage> Worker::messages() {
    std::array<char, 65536> buffer{};
    while (!closed_) {
        const ssize_t count = read(line_, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) break;  // nothing more for now
        if (count == 0) closed_ = true;
        received_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    std::vector<WorkerMessage> whole;
    while (received_.size() >= header_size) {
        std::uint64_t length = 0;
        std::memcpy(&length, received_.data() + 1, sizeof(length));
        if (received_.size() - header_size < length) break;
        whole.push_back(
            {.is_error = received_[0] == error_tag, .text = received_.substr(header_size, length)});
        received_.erase(0, header_size + length);
    }
    return whole;
}

Ending Worker::end() {
    if (process_ < 0) return {};
    int status = 0;
    kill(process_, SIGKILL);  // changes nothing for one that is at its end already
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    if (WIFSIGNALED(status)) {
        return {.text = fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))),
                .killed = WTERMSIG(status) == SIGKILL};
    }
    return {.text = fmt::format("exit code {}", WEXITSTATUS(status))};
}

}  // namespace trocar
