#pragma once

#include <filesystem>

namespace trocar {

/// The parts folder of one output, held by this process alone for as long as the object lives.
class PartsFolder {
  public:
    /// Creates the folder, or takes over what a run that was cut off left. Throws InputError when the output
    /// cannot be written there, or when another process is writing it.
    explicit PartsFolder(const std::filesystem::path& out);
    /// Removes the folder when it is empty: whatever is in it can still be merged by a later run.
    ~PartsFolder();
    PartsFolder(const PartsFolder&) = delete;
    PartsFolder& operator=(const PartsFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    /// Deletes everything in it: it has been merged.
    void clear() const;

  private:
    std::filesystem::path folder_;
    int lock_ = -1;  // descriptor of the folder
};

}  // namespace trocar
