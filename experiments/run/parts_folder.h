#pragma once

#include <filesystem>

namespace trocar {

/// Which run the parts are of.
enum class PartsOf { any_run, fresh_run };

/// The parts folder of one output, which this process alone writes for as long as the object lives.
class PartsFolder {
  public:
    /// Creates the folder, or takes over what a run that was cut off left. Throws InputError when the output
    /// cannot be written there, or when another process is writing it.
    PartsFolder(const std::filesystem::path& out, PartsOf run);
    /// Removes the folders when they are empty: whatever is in them can still be merged by a later run.
    ~PartsFolder();
    PartsFolder(const PartsFolder&) = delete;
    PartsFolder& operator=(const PartsFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return own_; }

    /// Deletes everything in it: it has been merged. A fresh run takes the place of what others left, too.
    void clear() const;

  private:
    std::filesystem::path folder_;  // of any run: the one that is locked
    std::filesystem::path own_;     // of this run
    int lock_ = -1;                 // descriptor of the folder
};

}  // namespace trocar
