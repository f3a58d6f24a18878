#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace trocar {

/// "12 s", "3 min 20 s" or "2 h 5 min".
std::string duration_text(std::chrono::seconds duration);

/// Tells how far a run is: on a terminal a bar that is drawn over itself, elsewhere a line at each tenth.
/// Both say how long the rest will take if it goes on as it went so far.
class Progress {
  public:
    explicit Progress(std::FILE* stream);
    /// Ends the bar's line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` of `total` are finished; called once for each, not from two threads at once.
    void show(std::size_t done, std::size_t total);

  private:
    void write(const std::string& text) const;
    void show_bar(std::size_t done, std::size_t total, const std::string& left);

    std::FILE* stream_;
    bool terminal_;
    bool bar_drawn_ = false;
    std::size_t tenths_told_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace trocar
