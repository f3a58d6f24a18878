#pragma once

#include <filesystem>

namespace trocar {

/// A folder of its own, removed with all that is in it.
class TemporaryFolder {
  public:
    /// Throws InputError where none can be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace trocar
