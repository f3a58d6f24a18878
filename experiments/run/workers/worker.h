#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "common/process/child.h"

namespace trocar {

/// Tasks, by their numbers, that a worker does one after the other.
struct Batch {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t attempt = 1;  ///< how often its first task has been started, this time included
    std::uint64_t left_out =
        0;  ///< parts of its first task, by number, a bit each: they ended a worker before
    [[nodiscard]] bool empty() const { return begin == end; }
};

/// What a worker reports of the task that it is at.
struct Reports {
    std::function<void(const std::string&)> done;  ///< it is done; with a text for the supervisor
    /// A part of it begins, below 64, that can be left out if need be; none: what cannot be left out.
    std::function<void(std::optional<std::uint64_t>)> part;
};

/// Does the tasks of a batch in their order, and reports after each.
using DoBatch = std::function<void(const Batch&, const Reports&)>;

/// What a worker has to say.
struct WorkerMessage {
    enum class Kind {
        done,   ///< a task; with its text
        part,   ///< of a task begins; with its number, or nothing
        error,  ///< it could not go on, and ends; with why
    };
    Kind kind;
    std::string text;
};

/// A child process that is given batches. It is a copy of this process at the moment it is made, so it knows
/// all that was loaded by then. It dies with this process, and with this object at the latest.
class Worker {
  public:
    /// Forks. Throws std::system_error.
    explicit Worker(const DoBatch& work);

    /// Gives it a batch; it must have done the one before.
    void give(const Batch& batch);

    /// Readable when there is a message, or the worker has ended.
    [[nodiscard]] int descriptor() const { return child_.line(); }
    [[nodiscard]] pid_t process() const { return child_.process(); }

    /// The messages that are there; does not wait.
    std::vector<WorkerMessage> messages();

    /// Whether, as far as messages() has seen, it is at its end.
    [[nodiscard]] bool closed() const { return child_.closed(); }
    /// Kills it if it is still there, waits for its end and says how it ended.
    Ending end() { return child_.end(); }

  private:
    Child child_;
};

}  // namespace trocar
