#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "results/hdf5_handles.h"

namespace trocar::hdf5 {

/// What every dataset says of itself.
struct Label {
    std::string name;
    std::string units;
    std::string long_name;
};

/// Lengths of a dataset's dimensions.
using Shape = std::vector<hsize_t>;

/// The HDF5 types of numbers: as a program holds them and, the same on every machine, as they are stored.
template <class Number>
struct NumberType;
template <>
struct NumberType<float> {
    static hid_t in_memory() { return H5T_NATIVE_FLOAT; }
    static hid_t stored() { return H5T_IEEE_F32LE; }
};
template <>
struct NumberType<double> {
    static hid_t in_memory() { return H5T_NATIVE_DOUBLE; }
    static hid_t stored() { return H5T_IEEE_F64LE; }
};
template <>
struct NumberType<std::int32_t> {
    static hid_t in_memory() { return H5T_NATIVE_INT32; }
    static hid_t stored() { return H5T_STD_I32LE; }
};
template <>
struct NumberType<std::int64_t> {
    static hid_t in_memory() { return H5T_NATIVE_INT64; }
    static hid_t stored() { return H5T_STD_I64LE; }
};

/// UTF-8 text of variable length, which h5py, pandas and xarray read as str.
Type text_type(hid_t near);

/// @{
/// Attributes of a file, group or dataset: a text or a whole number. Reading throws StoreError when there is
/// none.
void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, std::int64_t number);
std::string read_text_attribute(hid_t object, const std::string& name);
std::int64_t read_number_attribute(hid_t object, const std::string& name);
/// @}

/// An empty dataset, compressed in chunks of `rows_per_chunk` rows (0: of half a million bytes at most, and
/// a small one not chunked at all).
Dataset create_dataset(hid_t group, const Label& label, hid_t stored_type, const Shape& shape,
                       hsize_t rows_per_chunk = 0);

/// Throws StoreError when there is no such dataset.
Dataset open_dataset(hid_t group, const std::string& name);

/// Lengths of a dataset's dimensions.
Shape shape_of(hid_t dataset);

/// Writes all of a dataset from `data`, in C order.
void write_all(hid_t dataset, hid_t memory_type, const void* data);

/// Writes row `row` of a dataset whose rows hold `data`, in C order.
void write_row(hid_t dataset, hsize_t row, hid_t memory_type, const void* data);

/// Creates a dataset and writes `data`, which holds as many numbers as `shape` says.
template <class Number>
Dataset write_numbers(hid_t group, const Label& label, const Shape& shape, const Number* data) {
    Dataset dataset = create_dataset(group, label, NumberType<Number>::stored(), shape);
    write_all(dataset.id(), NumberType<Number>::in_memory(), data);
    return dataset;
}

/// Creates a dataset of one dimension and writes it.
void write_texts(hid_t group, const Label& label, const std::vector<std::string>& texts);
/// The texts of a dataset of one dimension and length `count`.
std::vector<std::string> read_texts(hid_t dataset, std::size_t count);

}  // namespace trocar::hdf5
