#include "experiments/run/workers/supervise.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <poll.h>

#include "experiments/run/workers/memory_use.h"

namespace trocar {
namespace {

using Clock = std::chrono::steady_clock;

// How often limits and `stop` are looked at.
constexpr std::chrono::milliseconds look_interval{50};
// Later than this means that the whole job stood still: Ctrl-Z, a suspended machine.
constexpr std::chrono::seconds stood_still{1};
// Of the memory limit: a worker that holds more of it when a task is done is replaced.
constexpr std::uint64_t held_part = 4;

/// A worker and what it is at.
struct Post {
    std::unique_ptr<Worker> worker;
    Batch batch;  ///< what is left of it; its first task is being done
    Clock::time_point since;
    std::uint64_t bytes_at_start = 0;   ///< that the worker held when it was made
    std::optional<std::uint64_t> part;  ///< of the task, that is being done

    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(Clock::now() - since).count();
    }
};

class Supervisor {
  public:
    Supervisor(std::deque<Batch> batches, const TaskLimits& limits, const DoBatch& work,
               const Listener& listener)
        : batches_(std::move(batches)), limits_(limits), work_(work), listener_(listener) {}

    void run(unsigned workers, const std::stop_token& stop) {
        posts_.resize(std::min<std::size_t>(std::max(workers, 1U), batches_.size()));
        while (!stop.stop_requested()) {
            for (Post& post : posts_) man(post);
            if (std::ranges::all_of(posts_, [](const Post& post) { return post.batch.empty(); })) return;
            wait();
            for (Post& post : posts_) {
                if (!post.batch.empty()) look_after(post);
                if (stop.stop_requested()) return;
            }
        }
    }

  private:
    /// Gives an idle post the next batch, and a worker if it has none.
    void man(Post& post) {
        if (!post.batch.empty() || batches_.empty()) return;
        if (post.worker) post.worker->messages();  // it may have died while it had nothing to do
        if (!post.worker || post.worker->closed()) {
            post.worker = std::make_unique<Worker>(work_);
            post.bytes_at_start = memory_use(post.worker->process()).value_or(0);
        }
        post.batch = batches_.front();
        batches_.pop_front();
        post.since = Clock::now();
        post.part.reset();
        post.worker->give(post.batch);
    }

    void wait() {
        std::vector<pollfd> lines;
        for (const Post& post : posts_) {
            if (!post.batch.empty()) {
                lines.push_back({.fd = post.worker->descriptor(), .events = POLLIN, .revents = 0});
            }
        }
        const auto before = Clock::now();
        poll(lines.data(), lines.size(), static_cast<int>(look_interval.count()));
        const auto late = Clock::now() - before - look_interval;
        if (late < stood_still) return;
        for (Post& post : posts_) post.since += late;
    }

    void look_after(Post& post) {
        bool has_done_one = false;
        for (const WorkerMessage& message : post.worker->messages()) {
            if (message.kind == WorkerMessage::Kind::error) throw WorkerError(message.text);
            if (message.kind == WorkerMessage::Kind::part) {
                post.part.reset();
                if (!message.text.empty()) post.part = std::stoull(message.text);
                continue;
            }
            const std::uint64_t task = post.batch.begin;
            has_done_one = true;
            next_task(post);
            listener_.done(task, message.text);
        }
        if (has_done_one && holds_more_than(post, limits_.bytes / held_part)) put_back(post);
        if (post.batch.empty()) return;
        if (post.worker->closed()) {
            const Ending ending = post.worker->end();
            if (ending.killed() && post.batch.attempt < most_attempts) {
                try_again(post);
            } else {
                lose(post, Loss::crashed, fmt::format("its process ended with {}", ending.text));
            }
        } else if (post.seconds() > limits_.seconds) {
            lose(post, Loss::timed_out, fmt::format("it took longer than {} s", limits_.seconds));
        } else if (holds_more_than(post, limits_.bytes)) {
            lose(post, Loss::out_of_memory,
                 fmt::format("it took more than {:.3g} GB of memory",
                             static_cast<double>(limits_.bytes) / 1e9));
        }
    }

    /// Beyond what it began with.
    [[nodiscard]] bool holds_more_than(const Post& post, std::uint64_t bytes) const {
        if (limits_.bytes == 0) return false;
        return memory_use(post.worker->process()).value_or(0) > post.bytes_at_start + bytes;
    }

    static void next_task(Post& post) {
        ++post.batch.begin;
        post.batch.attempt = 1;
        post.batch.left_out = 0;
        post.part.reset();
        post.since = Clock::now();
    }

    /// What is left of the batch is the next to be done, by a new worker.
    void put_back(Post& post) {
        post.worker.reset();
        if (!post.batch.empty()) batches_.push_front(post.batch);
        post.batch = {};
    }

    void try_again(Post& post) {
        ++post.batch.attempt;
        put_back(post);
    }

    /// Gives up the task that the post is at, or the part of it that it is at.
    void lose(Post& post, Loss loss, const std::string& reason) {
        if (post.part && (post.batch.left_out >> *post.part & 1U) == 0) {
            post.batch.left_out |= std::uint64_t{1} << *post.part;
            put_back(post);
            return;
        }
        const LostTask lost{.task = post.batch.begin,
                            .attempt = post.batch.attempt,
                            .loss = loss,
                            .reason = reason,
                            .seconds = post.seconds()};
        next_task(post);
        put_back(post);
        listener_.lost(lost);
    }

    std::deque<Batch> batches_;
    const TaskLimits& limits_;
    const DoBatch& work_;
    const Listener& listener_;
    std::vector<Post> posts_;
};

}  // namespace

void supervise(std::deque<Batch> batches, unsigned workers, const TaskLimits& limits,
               const std::stop_token& stop, const DoBatch& work, const Listener& listener) {
    Supervisor(std::move(batches), limits, work, listener).run(workers, stop);
}

}  // namespace trocar
