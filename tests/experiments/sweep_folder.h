#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "experiments/sweep/sweep.h"

namespace trocar {

/// A folder of its own for one test, removed afterwards.
class SweepFolder {
  public:
    SweepFolder();
    ~SweepFolder();
    SweepFolder(const SweepFolder&) = delete;
    SweepFolder& operator=(const SweepFolder&) = delete;

    [[nodiscard]] std::filesystem::path path(std::string_view name) const { return folder_ / name; }

    /// Writes the text into a file of that name.
    [[nodiscard]] std::filesystem::path write(std::string_view name, std::string_view text) const;

    /// Writes the text as "sweep.toml" and reads it.
    [[nodiscard]] Sweep read(std::string_view text) const;

  private:
    std::filesystem::path folder_;
};

/// A sweep of four cases, each a second of simulated time or two on a coarse sphere.
extern const std::string small_sweep;

/// `text` with its first `from` replaced by `to`; `from` must be there.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace trocar
