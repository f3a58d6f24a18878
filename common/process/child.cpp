#include "common/process/child.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trocar {
namespace {

[[noreturn]] void live(const Child::Life& life, pid_t parent, int line) noexcept {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(EXIT_FAILURE);  // it died in between
    life(line);
    _exit(EXIT_SUCCESS);  // not exit: what the parent has registered for its own end is not ours
}

}  // namespace

bool Ending::killed() const { return signal == SIGKILL; }

Child::Child(const Life& life) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::system_error(errno, std::generic_category(), "making a line to a process");
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) {
        const int error = errno;
        for (const int end : ends) close(end);
        throw std::system_error(error, std::generic_category(), "starting a process");
    }
    if (process_ == 0) {
        close(ends[0]);
        live(life, parent, ends[1]);
    }
    close(ends[1]);
    line_ = ends[0];
    fcntl(line_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
    end();
    close(line_);
}

std::vector<Message> Child::messages() {
    std::array<char, 1U << 16U> buffer{};
    while (!closed_) {
        const ssize_t count = read(line_, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) break;  // nothing more for now
        if (count == 0) closed_ = true;
        received_.append({buffer.data(), static_cast<std::size_t>(count)});
    }
    std::vector<Message> whole;
    while (std::optional<Message> message = received_.next()) whole.push_back(std::move(*message));
    return whole;
}

Ending Child::end() {
    if (process_ < 0) return {};
    int status = 0;
    kill(process_, SIGKILL);  // changes nothing for one that is at its end already
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    if (!WIFSIGNALED(status)) return {.text = fmt::format("exit code {}", WEXITSTATUS(status))};
    const int signal = WTERMSIG(status);
    return {.text = fmt::format("signal {} ({})", signal, strsignal(signal)), .signal = signal};
}

}  // namespace trocar
