#include "experiments/run/workers/worker.h"

#include <cerrno>
#include <csignal>
#include <exception>
#include <utility>

#include <unistd.h>

namespace trocar {
namespace {

constexpr char done_letter = 'd', part_letter = 'p', error_letter = 'e';

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

void report(int line, char letter, const std::string& text) {
    if (!send_message(line, letter, text)) _exit(1);  // the supervisor is gone
}

/// Leaves a child nothing of its parent's but what it was copied with and its end of the line: no other
/// files and no locks on them, no signals that the parent waits for.
int cut_loose(int line) {
    // Ctrl-C reaches every process of the terminal, and the SIGTERM of a batch system every one of the job;
    // the supervisor decides.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    constexpr int own = STDERR_FILENO + 1;
    if (line != own) dup2(line, own);
    close_range(own + 1, ~0U, 0);
    return own;
}

void live(const DoBatch& work, int line) {
    try {
        Batch batch;
        while (read_all(line, reinterpret_cast<char*>(&batch), sizeof(batch))) {
            work(batch, {.done = [&](const std::string& text) { report(line, done_letter, text); },
                         .part =
                             [&](std::optional<std::uint64_t> part) {
                                 report(line, part_letter, part ? std::to_string(*part) : "");
                             }});
        }
    } catch (const std::exception& error) {
        report(line, error_letter, error.what());
    } catch (...) {
        report(line, error_letter, "something that is no std::exception was thrown");
    }
}

WorkerMessage::Kind kind_of(char letter) {
    switch (letter) {
        case done_letter:
            return WorkerMessage::Kind::done;
        case part_letter:
            return WorkerMessage::Kind::part;
        default:
            return WorkerMessage::Kind::error;
    }
}

}  // namespace

Worker::Worker(const DoBatch& work) : child_([&](int line) { live(work, cut_loose(line)); }) {}

void Worker::give(const Batch& batch) {
    // One that has died is noticed where it is listened to.
    (void)send_bytes(child_.line(), {reinterpret_cast<const char*>(&batch), sizeof(batch)});
}

std::vector<WorkerMessage> Worker::messages() {
    std::vector<WorkerMessage> messages;
    for (Message& message : child_.messages())
        messages.push_back({.kind = kind_of(message.letter), .text = std::move(message.text)});
    return messages;
}

}  // namespace trocar
