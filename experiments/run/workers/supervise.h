#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string>

#include "experiments/run/workers/worker.h"

namespace trocar {

/// What a task may take. A worker that takes more is killed.
struct TaskLimits {
    double seconds = 600;
    std::uint64_t bytes = 0;  ///< of memory beyond what the worker began with; 0: no limit
};

/// Why a task has no report.
enum class Loss {
    crashed,        ///< its process ended by itself
    timed_out,      ///< it took longer than the limit
    out_of_memory,  ///< it took more memory than the limit
};

/// A task whose process is killed from outside (by a person, or by a system short of memory) is started this
/// often before it counts as lost.
inline constexpr std::uint64_t most_attempts = 3;

/// A task that was lost.
struct LostTask {
    std::uint64_t task;
    std::uint64_t attempt;  ///< how often it was started
    Loss loss;
    std::string reason;  ///< such as "its process ended with signal 11 (Segmentation fault)"
    double seconds;      ///< that it ran
};

/// A worker could not go on although its tasks did nothing wrong, such as for a full disk.
struct WorkerError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What a supervisor is told.
struct Listener {
    std::function<void(std::uint64_t task, const std::string& report)> done;
    std::function<void(const LostTask&)> lost;
};

/// Has the batches done by so many workers at once, each batch by one of them, in their order. A task that
/// ends its worker, or takes more than the limits, is lost; a new worker goes on with the next one. When
/// `stop` is requested workers are killed where they are. The listener is called in this thread. Throws
/// WorkerError, and what the listener throws; then too all workers are killed.
///
/// A part of a task that ends its worker, or takes more than the limits, is left out, and the task is started
/// again; that is no attempt. A worker that holds a quarter of a task's memory when it has done one is
/// replaced, so that what a task leaves behind does not count against the next. Time in which this process
/// itself was stopped counts for nobody.
void supervise(std::deque<Batch> batches, unsigned workers, const TaskLimits& limits,
               const std::stop_token& stop, const DoBatch& work, const Listener& listener);

}  // namespace trocar
