#include "experiments/cli/stop_on_signal.h"

#include <ctime>

#include <fmt/format.h>

#include "experiments/say.h"

namespace trocar {
namespace {

// How long the end of the program may have to wait for the waiting thread.
constexpr timespec patience{.tv_sec = 0, .tv_nsec = 20'000'000};

}  // namespace

StopOnSignal::StopOnSignal() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
    waiter_ = std::jthread([this](const std::stop_token& over) { wait(over); });
}

StopOnSignal::~StopOnSignal() {
    waiter_.request_stop();
    waiter_.join();
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

// Waiting in a thread, not in a handler: a handler may not call request_stop.
void StopOnSignal::wait(const std::stop_token& over) {
    while (!over.stop_requested()) {
        if (sigtimedwait(&signals_, nullptr, &patience) < 0) continue;
        stop_.request_stop();
        say("\nstopping; finished cases are kept\n");
        pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);  // from now on a signal has its usual effect
        return;
    }
}

}  // namespace trocar
