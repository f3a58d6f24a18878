#include "results/hdf5_handles.h"

#include <fmt/format.h>

#include "results/store.h"
#include "results/supervised.h"

namespace trocar::hdf5 {
namespace {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// Of "file write failed: time = …, error message = 'No space left on device', buf = …" what the system said.
std::string reason_of_system(const std::string& message) {
    constexpr std::string_view before = "error message = '";
    const std::size_t found = message.find(before);
    if (found == std::string::npos) return message;
    const std::size_t start = found + before.size();
    return message.substr(start, message.find('\'', start) - start);
}

/// What the function deepest inside HDF5 said. To be asked first: the next call into HDF5 forgets it.
std::string innermost_message() {
    std::string message;
    const auto keep_first = [](unsigned level, const H5E_error2_t* error, void* kept) -> herr_t {
        if (level == 0 && error->desc != nullptr) *static_cast<std::string*>(kept) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &message);
    std::erase(message, '\n');  // it may hold a date that ends its line
    return message.empty() ? "HDF5 gives no reason" : reason_of_system(message);
}

/// A name as HDF5's functions give it: they return the length, and fill a buffer when there is one.
template <class Function>
std::string name_from(Function function, hid_t id) {
    const ssize_t length = function(id, nullptr, 0);
    if (length <= 0) return {};
    std::string name(static_cast<std::size_t>(length), '\0');
    function(id, name.data(), name.size() + 1);
    return name;
}

std::string place_of(hid_t near, std::string_view object) {
    const std::string path = name_from(H5Iget_name, near);
    const char* const slash = object.empty() || path.ends_with('/') ? "" : "/";
    return fmt::format("{}: {}{}{}", name_from(H5Fget_name, near), path, slash, object);
}

PropertyList group_properties(hid_t near, bool ordered) {
    PropertyList list(checked(H5Pcreate(H5P_GROUP_CREATE), near, "", "cannot prepare a group"));
    // Without times, the same data gives the same bytes.
    checked(H5Pset_obj_track_times(list.id(), false), near, "", "cannot prepare a group");
    if (ordered) {
        checked(H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), near,
                "", "cannot prepare a group");
    }
    return list;
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
    // After a file that could not be closed, on a full disk, the library's own tidying at exit would crash.
    [[maybe_unused]] static const herr_t no_tidying = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }

void fail(const std::filesystem::path& file, std::string_view action) {
    const std::string message = fmt::format("{}: {}: {}", file.string(), action, innermost_message());
    end_with_error(message);
    throw StoreError(message);
}

void fail(hid_t near, std::string_view object, std::string_view action) {
    const std::string reason = innermost_message();
    const std::string message = fmt::format("{}: {}: {}", place_of(near, object), action, reason);
    end_with_error(message);
    throw StoreError(message);
}

void refuse(hid_t near, std::string_view object, std::string_view reason) {
    throw StoreError(fmt::format("{}: {}", place_of(near, object), reason));
}

Group open_group(hid_t parent, const std::string& name) {
    return Group(checked(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), parent, name, "cannot open the group"));
}

Group create_group(hid_t parent, const std::string& name, bool ordered) {
    const PropertyList properties = group_properties(parent, ordered);
    return Group(checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), parent,
                         name, "cannot create the group"));
}

bool exists(hid_t parent, const std::string& name) {
    return checked(H5Lexists(parent, name.c_str(), H5P_DEFAULT), parent, name, "cannot look it up") > 0;
}

std::vector<std::string> member_names(hid_t group) {
    const PropertyList properties(checked(H5Gget_create_plist(group), group, "", "cannot read the group"));
    unsigned order = 0;
    checked(H5Pget_link_creation_order(properties.id(), &order), group, "", "cannot read the group");
    const auto index = (order & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;

    // One by one: H5Literate of libhdf5 1.10.8 frees memory that is not its own where a link is damaged.
    std::vector<std::string> names;
    H5G_info_t info{};
    checked(H5Gget_info(group, &info), group, "", "cannot read the group");
    for (hsize_t i = 0; i < info.nlinks; ++i) {
        const auto name_at = [&](hid_t id, char* buffer, std::size_t size) {
            return H5Lget_name_by_idx(id, ".", index, H5_ITER_INC, i, buffer, size, H5P_DEFAULT);
        };
        names.push_back(name_from(name_at, group));
        if (names.back().empty()) fail(group, "", "cannot list the group");
    }
    return names;
}

}  // namespace trocar::hdf5
