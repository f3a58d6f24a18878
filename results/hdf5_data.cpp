#include "results/hdf5_data.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace trocar::hdf5 {
namespace {

constexpr auto cannot_write = "cannot write";
constexpr auto cannot_read = "cannot read";
constexpr unsigned deflate_level = 4;
constexpr hsize_t chunk_bytes = 1U << 19U;
// Up to this size data lie in the dataset's own header: an index of chunks would take more room than
// compression saves, and most of the time that it takes to write, read or copy the dataset.
constexpr hsize_t compact_bytes = 2048;

Dataspace scalar_space(hid_t near) {
    return Dataspace(checked(H5Screate(H5S_SCALAR), near, "", "cannot make a dataspace"));
}

Attribute create_attribute(hid_t object, const std::string& name, hid_t type) {
    const Dataspace space = scalar_space(object);
    return Attribute(checked(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                             object, name, "cannot create the attribute"));
}

/// Opens an attribute that holds one value of class `wanted`.
Attribute open_attribute(hid_t object, const std::string& name, H5T_class_t wanted) {
    Attribute attribute(
        checked(H5Aopen(object, name.c_str(), H5P_DEFAULT), object, name, "there is no such attribute"));
    const Type type(checked(H5Aget_type(attribute.id()), object, name, cannot_read));
    const Dataspace space(checked(H5Aget_space(attribute.id()), object, name, cannot_read));
    const bool fits = H5Tget_class(type.id()) == wanted && H5Sget_simple_extent_npoints(space.id()) == 1 &&
                      (wanted != H5T_STRING || H5Tis_variable_str(type.id()) > 0);
    if (!fits) {
        refuse(object, name,
               wanted == H5T_STRING ? "the attribute is not a text of variable length"
                                    : "the attribute is not a whole number");
    }
    return attribute;
}

/// A pointer that HDF5 reads from: a text that has a zero inside would be cut there.
const char* stored_text(hid_t near, const std::string& name, const std::string& text) {
    if (text.find('\0') != std::string::npos) refuse(near, name, "a text with a zero byte cannot be stored");
    return text.c_str();
}

void set_storage(hid_t near, const PropertyList& list, const Shape& shape, std::size_t value_bytes,
                 hsize_t rows_per_chunk) {
    const auto set = [&](herr_t result) { checked(result, near, "", "cannot prepare a dataset"); };
    // Without times, the same data gives the same bytes.
    set(H5Pset_obj_track_times(list.id(), false));
    if (std::ranges::find(shape, 0U) != shape.end()) return;  // nothing to store, and no chunk is empty

    const hsize_t all_bytes =
        std::accumulate(shape.begin(), shape.end(), hsize_t{value_bytes}, std::multiplies{});
    if (rows_per_chunk == 0 && all_bytes <= compact_bytes) {
        set(H5Pset_layout(list.id(), H5D_COMPACT));
        return;
    }
    Shape chunk = shape;
    const hsize_t row_bytes =
        std::accumulate(shape.begin() + 1, shape.end(), hsize_t{value_bytes}, std::multiplies{});
    chunk[0] = rows_per_chunk != 0 ? rows_per_chunk : std::max<hsize_t>(chunk_bytes / row_bytes, 1);
    chunk[0] = std::min(chunk[0], shape[0]);
    set(H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data()));
    set(H5Pset_shuffle(list.id()));
    set(H5Pset_deflate(list.id(), deflate_level));
}

}  // namespace

Type text_type(hid_t near) {
    Type type(checked(H5Tcopy(H5T_C_S1), near, "", "cannot make a text type"));
    checked(H5Tset_size(type.id(), H5T_VARIABLE), near, "", "cannot make a text type");
    checked(H5Tset_cset(type.id(), H5T_CSET_UTF8), near, "", "cannot make a text type");
    return type;
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
    const Type type = text_type(object);
    const char* const pointer = stored_text(object, name, text);
    const Attribute attribute = create_attribute(object, name, type.id());
    checked(H5Awrite(attribute.id(), type.id(), static_cast<const void*>(&pointer)), object, name,
            cannot_write);
}

void write_attribute(hid_t object, const std::string& name, std::int64_t number) {
    const Attribute attribute = create_attribute(object, name, H5T_STD_I64LE);
    checked(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &number), object, name, cannot_write);
}

std::string read_text_attribute(hid_t object, const std::string& name) {
    const Attribute attribute = open_attribute(object, name, H5T_STRING);
    const Type type = text_type(object);
    const Dataspace space = scalar_space(object);
    char* pointer = nullptr;
    checked(H5Aread(attribute.id(), type.id(), static_cast<void*>(&pointer)), object, name, cannot_read);
    std::string text = pointer == nullptr ? "" : pointer;
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, static_cast<void*>(&pointer));
    return text;
}

std::int64_t read_number_attribute(hid_t object, const std::string& name) {
    const Attribute attribute = open_attribute(object, name, H5T_INTEGER);
    std::int64_t number = 0;
    checked(H5Aread(attribute.id(), H5T_NATIVE_INT64, &number), object, name, cannot_read);
    return number;
}

Dataset create_dataset(hid_t group, const Label& label, hid_t stored_type, const Shape& shape,
                       hsize_t rows_per_chunk) {
    const PropertyList list(
        checked(H5Pcreate(H5P_DATASET_CREATE), group, label.name, "cannot prepare a dataset"));
    set_storage(group, list, shape, H5Tget_size(stored_type), rows_per_chunk);
    const Dataspace space(checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                                  group, label.name, "cannot make a dataspace"));
    Dataset dataset(checked(
        H5Dcreate2(group, label.name.c_str(), stored_type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
        group, label.name, "cannot create the dataset"));
    write_attribute(dataset.id(), "units", label.units);
    write_attribute(dataset.id(), "long_name", label.long_name);
    return dataset;
}

Dataset open_dataset(hid_t group, const std::string& name) {
    return Dataset(
        checked(H5Dopen2(group, name.c_str(), H5P_DEFAULT), group, name, "cannot open the dataset"));
}

Shape shape_of(hid_t dataset) {
    const Dataspace space(checked(H5Dget_space(dataset), dataset, "", cannot_read));
    Shape shape(
        static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space.id()), dataset, "", cannot_read)));
    checked(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr), dataset, "", cannot_read);
    return shape;
}

void write_all(hid_t dataset, hid_t memory_type, const void* data) {
    checked(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), dataset, "", cannot_write);
}

void write_row(hid_t dataset, hsize_t row, hid_t memory_type, const void* data) {
    const auto done = [&](auto result) { return checked(result, dataset, "", cannot_write); };
    Shape count = shape_of(dataset);
    if (std::ranges::find(count, 0U) != count.end()) return;
    Shape start(count.size(), 0);
    start[0] = row;
    count[0] = 1;
    const Dataspace file_space(done(H5Dget_space(dataset)));
    done(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    const Dataspace memory_space(
        done(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr)));
    done(H5Dwrite(dataset, memory_type, memory_space.id(), file_space.id(), H5P_DEFAULT, data));
}

void write_texts(hid_t group, const Label& label, const std::vector<std::string>& texts) {
    const Type type = text_type(group);
    std::vector<const char*> pointers;
    pointers.reserve(texts.size());
    for (const std::string& text : texts) pointers.push_back(stored_text(group, label.name, text));
    const Dataset dataset = create_dataset(group, label, type.id(), {texts.size()});
    write_all(dataset.id(), type.id(), static_cast<const void*>(pointers.data()));
}

std::vector<std::string> read_texts(hid_t dataset, std::size_t count) {
    const Type type = text_type(dataset);
    const Dataspace space(checked(H5Dget_space(dataset), dataset, "", cannot_read));
    std::vector<char*> pointers(count);
    const herr_t result =
        H5Dread(dataset, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<void*>(pointers.data()));
    checked(result, dataset, "", cannot_read);
    std::vector<std::string> texts;
    texts.reserve(count);
    for (const char* pointer : pointers) texts.emplace_back(pointer == nullptr ? "" : pointer);
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, static_cast<void*>(pointers.data()));
    return texts;
}

}  // namespace trocar::hdf5
