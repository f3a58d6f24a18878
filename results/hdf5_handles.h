#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hdf5.h>

/// A thin layer over HDF5's C interface. Included by .cpp files of this folder and its tests only.
namespace trocar::hdf5 {

/// Held while HDF5 is in use. Lets one thread in at a time, since HDF5 may be built without thread safety,
/// and keeps HDF5 from printing its errors, which reach the user as StoreError instead.
class Session {
  public:
    Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

  private:
    std::unique_lock<std::mutex> lock_;
    H5E_auto2_t printer_ = nullptr;
    void* printer_data_ = nullptr;
};

/// An HDF5 identifier, released at the end of its scope.
template <herr_t (*Release)(hid_t)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(hid_t id) : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { release(); }

    [[nodiscard]] hid_t id() const { return id_; }

    /// Releases it now; negative when that fails, as closing a file does on a full disk.
    herr_t release() { return id_ < 0 ? 0 : Release(std::exchange(id_, H5I_INVALID_HID)); }

  private:
    hid_t id_ = H5I_INVALID_HID;
};

/// @{
/// What HDF5 knows by an identifier.
using File = Handle<H5Fclose>;
using Group = Handle<H5Gclose>;
using Dataset = Handle<H5Dclose>;
using Dataspace = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Attribute = Handle<H5Aclose>;
using PropertyList = Handle<H5Pclose>;
/// @}

/// Throws StoreError: the file, what could not be done and HDF5's innermost message.
[[noreturn]] void fail(const std::filesystem::path& file, std::string_view action);

/// The same, about `object` in the open file, group or dataset `near`.
[[noreturn]] void fail(hid_t near, std::string_view object, std::string_view action);

/// Throws StoreError about an object whose content is wrong although HDF5 could read it.
[[noreturn]] void refuse(hid_t near, std::string_view object, std::string_view reason);

/// Hands through what an HDF5 function returned, unless it says that it failed.
template <class Result>
Result checked(Result result, hid_t near, std::string_view object, std::string_view action) {
    if (result < 0) fail(near, object, action);
    return result;
}

/// Throws StoreError when there is no such group.
Group open_group(hid_t parent, const std::string& name);

/// A group that keeps its members in the order of their creation when `ordered`; that costs some kilobytes.
Group create_group(hid_t parent, const std::string& name, bool ordered = false);

/// Whether `parent` has a member of that name.
bool exists(hid_t parent, const std::string& name);

/// Members of a group in alphabetic order or, when it was created so, in the order of their creation.
std::vector<std::string> member_names(hid_t group);

}  // namespace trocar::hdf5
