#pragma once

#include <filesystem>

namespace trocar {

/// A file that appears under its name only when it is whole. It is written beside it, under
/// `<name>.tmp.<host>.<pid>`, so that two machines sharing a folder do not write into each other's file.
class PendingFile {
  public:
    explicit PendingFile(std::filesystem::path name);
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Removes the temporary file unless it was published.
    ~PendingFile();

    /// Where to write.
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings the closed temporary file to the disk and gives it its name. Throws StoreError.
    void publish();

  private:
    std::filesystem::path name_;
    std::filesystem::path temporary_;
};

/// Removes what killed processes of this machine left in `folder` of the file `name`, or of all files when it
/// is empty. To be called only by who is alone in writing them.
void remove_abandoned(const std::filesystem::path& folder, const std::string& name);

}  // namespace trocar
