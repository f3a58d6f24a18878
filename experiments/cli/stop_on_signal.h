#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace trocar {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM request a stop instead of ending the program; a second one
/// ends it at once. To be made before other threads are: they inherit that these signals are not theirs.
class StopOnSignal {
  public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

  private:
    void wait(const std::stop_token& over);

    sigset_t signals_{};
    sigset_t mask_before_{};
    std::stop_source stop_;
    std::jthread waiter_;
};

}  // namespace trocar
