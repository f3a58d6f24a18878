#include "experiments/run/case_pool.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace trocar {

void for_each_case(std::span<const CaseInputs> cases, unsigned jobs, const std::stop_token& stop,
                   const std::function<void(const CaseInputs&, const std::stop_token&)>& run) {
    std::stop_source either;  // the caller's stop, or an error of ours
    const std::stop_callback forward(stop, [&] { either.request_stop(); });
    std::atomic<std::size_t> next = 0;
    std::mutex error_guard;
    std::exception_ptr first_error;

    const auto work = [&] {
        while (!either.stop_requested()) {
            const std::size_t index = next++;
            if (index >= cases.size()) return;
            try {
                run(cases[index], either.get_token());
            } catch (...) {
                const std::scoped_lock lock(error_guard);
                if (!first_error) first_error = std::current_exception();
                either.request_stop();
            }
        }
    };
    {
        const auto workers = std::min<std::size_t>(std::max(jobs, 1U), cases.size());
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < workers; ++i) threads.emplace_back(work);
    }
    if (first_error) std::rethrow_exception(first_error);
}

}  // namespace trocar
