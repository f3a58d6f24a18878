#include "experiments/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace trocar {
namespace {

constexpr std::size_t bar_width = 30;

}  // namespace

std::string duration_text(std::chrono::seconds duration) {
    const auto seconds = duration.count();
    if (seconds < 60) return fmt::format("{} s", seconds);
    if (seconds < 3600) return fmt::format("{} min {} s", seconds / 60, seconds % 60);
    return fmt::format("{} h {} min", seconds / 3600, seconds / 60 % 60);
}

Progress::Progress(std::FILE* stream) : stream_(stream), terminal_(isatty(fileno(stream)) == 1) {}

Progress::~Progress() {
    if (bar_drawn_) write("\n");
}

// Where nobody can be told, the run goes on all the same.
void Progress::write(const std::string& text) const {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stream_));
    static_cast<void>(std::fflush(stream_));
}

void Progress::show(std::size_t done, std::size_t total) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const auto rest = elapsed * (static_cast<double>(total - done) / static_cast<double>(done));
    const std::string left =
        done == total
            ? ""
            : fmt::format(", about {} left", duration_text(std::chrono::ceil<std::chrono::seconds>(rest)));
    if (terminal_) {
        show_bar(done, total, left);
        return;
    }
    const std::size_t tenths = 10 * done / total;
    if (tenths == tenths_told_) return;
    tenths_told_ = tenths;
    write(fmt::format("{} of {} cases done{}\n", done, total, left));
}

void Progress::show_bar(std::size_t done, std::size_t total, const std::string& left) {
    const std::size_t filled = bar_width * done / total;
    // "\33[K" wipes what a longer text before left of the line.
    write(fmt::format("\r[{:=<{}}{: <{}}] {}/{}{}\33[K", "", filled, "", bar_width - filled, done, total,
                      left));
    bar_drawn_ = true;
}

}  // namespace trocar
