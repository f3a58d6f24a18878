#include <array>
#include <cstdint>

#include "results/table.h"

// The attributes of HDF5's dimension scales, written here because the library's own H5DSattach_scale stores
// padding bytes it never set, which makes two files with the same data differ.
namespace trocar {
namespace {

constexpr auto cannot_attach = "cannot attach it to its dimension";

/// One entry of REFERENCE_LIST: a column and which of its dimensions follows the scale.
struct BackReference {
    hobj_ref_t dataset = 0;
    std::int32_t dimension = 0;
    std::int32_t padding = 0;
};

hdf5::Attribute create_attribute(hid_t dataset, const char* name, hid_t type, const hdf5::Dataspace& space) {
    return hdf5::Attribute(hdf5::checked(
        H5Acreate2(dataset, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), dataset, name, cannot_attach));
}

hdf5::Dataspace list_space(hid_t near, hsize_t length) {
    return hdf5::Dataspace(hdf5::checked(H5Screate_simple(1, &length, nullptr), near, "", cannot_attach));
}

/// The standard wants these two texts with a fixed length.
void write_fixed_text(hid_t dataset, const char* name, const std::string& text) {
    const auto done = [&](auto result) { return hdf5::checked(result, dataset, name, cannot_attach); };
    const hdf5::Type type(done(H5Tcopy(H5T_C_S1)));
    done(H5Tset_size(type.id(), text.size() + 1));
    const hdf5::Dataspace space(done(H5Screate(H5S_SCALAR)));
    const hdf5::Attribute attribute = create_attribute(dataset, name, type.id(), space);
    done(H5Awrite(attribute.id(), type.id(), text.c_str()));
}

/// DIMENSION_LIST of a column: for its one dimension, a list of one scale.
void point_to_scale(hid_t column, hobj_ref_t scale) {
    const auto done = [&](auto result) { return hdf5::checked(result, column, "", cannot_attach); };
    const hdf5::Type type(done(H5Tvlen_create(H5T_STD_REF_OBJ)));
    const hdf5::Attribute attribute =
        create_attribute(column, "DIMENSION_LIST", type.id(), list_space(column, 1));
    const hvl_t list{.len = 1, .p = &scale};
    done(H5Awrite(attribute.id(), type.id(), &list));
}

void point_back(hid_t scale, const std::vector<BackReference>& columns) {
    const auto done = [&](auto result) { return hdf5::checked(result, scale, "", cannot_attach); };
    const hdf5::Type type(done(H5Tcreate(H5T_COMPOUND, sizeof(BackReference))));
    done(H5Tinsert(type.id(), "dataset", offsetof(BackReference, dataset), H5T_STD_REF_OBJ));
    done(H5Tinsert(type.id(), "dimension", offsetof(BackReference, dimension), H5T_NATIVE_INT32));
    const hdf5::Attribute attribute =
        create_attribute(scale, "REFERENCE_LIST", type.id(), list_space(scale, columns.size()));
    done(H5Awrite(attribute.id(), type.id(), columns.data()));
}

hobj_ref_t reference_to(hid_t group, const std::string& name) {
    hobj_ref_t reference = 0;
    hdf5::checked(H5Rcreate(&reference, group, name.c_str(), H5R_OBJECT, -1), group, name, cannot_attach);
    return reference;
}

}  // namespace

void attach_to_dimension(hid_t group, const std::string& scale) {
    const hobj_ref_t scale_reference = reference_to(group, scale);
    std::vector<BackReference> columns;
    for (const std::string& name : hdf5::member_names(group)) {
        if (name == scale) continue;
        point_to_scale(hdf5::open_dataset(group, name).id(), scale_reference);
        columns.push_back({.dataset = reference_to(group, name)});
    }
    const hdf5::Dataset dataset = hdf5::open_dataset(group, scale);
    write_fixed_text(dataset.id(), "CLASS", "DIMENSION_SCALE");
    write_fixed_text(dataset.id(), "NAME", scale);
    point_back(dataset.id(), columns);
}

}  // namespace trocar
