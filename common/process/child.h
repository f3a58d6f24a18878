#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "common/process/messages.h"

namespace trocar {

/// How a process came to its end.
struct Ending {
    std::string text;  ///< "signal 11 (Segmentation fault)", or "exit code 1"
    int signal = 0;    ///< that ended it; 0 when it exited

    /// By signal 9, which no process sends itself by accident.
    [[nodiscard]] bool killed() const;
};

/// A child process and the line to it. It is a copy of this process at the moment it is made, and has all of
/// its files and signals: whether it should keep them is for `life` to decide. It dies with the thread that
/// made it, and at the end of this object's scope at the latest.
class Child {
  public:
    /// What the child does, with its end of the line: a socket on which it waits until it can send or
    /// receive. When it returns, the child ends with exit code 0; when it throws, with signal 6.
    using Life = std::function<void(int line)>;

    /// Forks. Throws std::system_error.
    explicit Child(const Life& life);
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child();

    /// This end of the line, a socket: readable when there is a message, or the child has ended. To be read
    /// through messages() alone; what is sent does not wait.
    [[nodiscard]] int line() const { return line_; }
    /// -1 after end().
    [[nodiscard]] pid_t process() const { return process_; }

    /// The messages that are there in full; does not wait.
    std::vector<Message> messages();

    /// Whether, as far as messages() has seen, the child has let go of the line, as it does when it ends.
    [[nodiscard]] bool closed() const { return closed_; }

    /// Kills it if it is still there, waits for its end and says how it ended; nothing when it has said so
    /// before.
    Ending end();

  private:
    pid_t process_ = -1;
    int line_ = -1;
    bool closed_ = false;
    MessageCutter received_;
};

}  // namespace trocar
