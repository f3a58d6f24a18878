#include "results/table.h"

#include <algorithm>

#include <fmt/format.h>

#include "results/store.h"

namespace trocar {
namespace {

// A damaged file may claim any number of rows: more than any campaign has, more than the bytes stored for
// them can hold.
constexpr hsize_t max_rows = 10'000'000;
constexpr hsize_t max_compression = 1032;  // of deflate

template <class Number>
std::vector<Number> read_numbers(hid_t dataset, std::size_t count) {
    std::vector<Number> numbers(count);
    hdf5::checked(H5Dread(dataset, hdf5::NumberType<Number>::in_memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                          numbers.data()),
                  dataset, "", "cannot read");
    return numbers;
}

std::size_t length(const Column& column) {
    return std::visit([](const auto& values) { return values.size(); }, column.values);
}

void write_column(hid_t group, const Column& column) {
    if (const auto* text = std::get_if<Texts>(&column.values)) {
        hdf5::write_texts(group, column.label, *text);
    } else if (const auto* whole = std::get_if<WholeNumbers>(&column.values)) {
        hdf5::write_numbers(group, column.label, {whole->size()}, whole->data());
    } else {
        const auto& figures = std::get<Figures>(column.values);
        hdf5::write_numbers(group, column.label, {figures.size()}, figures.data());
    }
}

void add_column(Table& table, hid_t group, const std::string& name) {
    const Column& column = table.columns.emplace_back(read_column(group, name));
    if (table.columns.size() == 1) table.rows = length(column);
    if (length(column) != table.rows) {
        hdf5::refuse(group, name,
                     fmt::format("expected {} rows as in {}, found {}", table.rows,
                                 table.columns.front().label.name, length(column)));
    }
}

template <class Values>
const Values& values_of(const Table& table, const std::string& name, hid_t group, const char* expected) {
    const Column* column = table.find(name);
    if (column == nullptr) hdf5::refuse(group, name, "the column is missing");
    const auto* values = std::get_if<Values>(&column->values);
    if (values == nullptr) hdf5::refuse(group, name, fmt::format("expected {}", expected));
    return *values;
}

}  // namespace

const Column* Table::find(const std::string& name) const {
    const auto same_name = [&](const Column& column) { return column.label.name == name; };
    const auto found = std::ranges::find_if(columns, same_name);
    return found == columns.end() ? nullptr : &*found;
}

void Table::erase(const std::string& name) {
    std::erase_if(columns, [&](const Column& column) { return column.label.name == name; });
}

Table table_of(const std::vector<Cell>& cells) {
    Table table{.columns = {}, .rows = 1};
    for (const Cell& cell : cells) {
        Column column{.label = {cell.name, cell.units, cell.long_name}, .values = {}};
        std::visit([&](const auto& value) { column.values = std::vector{value}; }, cell.value);
        table.columns.push_back(std::move(column));
    }
    return table;
}

void write_table(hid_t group, const Table& table) {
    for (const Column& column : table.columns) write_column(group, column);
}

Column read_column(hid_t group, const std::string& name) {
    const hdf5::Dataset dataset = hdf5::open_dataset(group, name);
    const hdf5::Shape shape = hdf5::shape_of(dataset.id());
    if (shape.size() != 1 || shape[0] > max_rows) {
        hdf5::refuse(group, name, fmt::format("expected one dimension of at most {} rows", max_rows));
    }
    const hdf5::Type type(hdf5::checked(H5Dget_type(dataset.id()), group, name, "cannot read"));
    const hsize_t stored = H5Dget_storage_size(dataset.id());
    if (shape[0] * H5Tget_size(type.id()) / max_compression > stored) {
        hdf5::refuse(group, name,
                     fmt::format("claims {} rows, but only {} bytes are stored", shape[0], stored));
    }
    Column column{.label = {.name = name,
                            .units = hdf5::read_text_attribute(dataset.id(), "units"),
                            .long_name = hdf5::read_text_attribute(dataset.id(), "long_name")},
                  .values = {}};
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind == H5T_STRING && H5Tis_variable_str(type.id()) > 0) {
        column.values = hdf5::read_texts(dataset.id(), shape[0]);
    } else if (kind == H5T_INTEGER) {
        column.values = read_numbers<std::int64_t>(dataset.id(), shape[0]);
    } else if (kind == H5T_FLOAT) {
        column.values = read_numbers<double>(dataset.id(), shape[0]);
    } else {
        hdf5::refuse(group, name, "expected text of variable length, whole numbers or figures");
    }
    return column;
}

Table read_table(hid_t group) {
    Table table;
    for (const std::string& name : hdf5::member_names(group)) add_column(table, group, name);
    return table;
}

Table read_table(hid_t group, std::span<const char* const> names) {
    Table table;
    for (const char* name : names) {
        if (hdf5::exists(group, name)) add_column(table, group, name);
    }
    return table;
}

const Texts& texts(const Table& table, const std::string& name, hid_t group) {
    return values_of<Texts>(table, name, group, "texts");
}

const WholeNumbers& whole_numbers(const Table& table, const std::string& name, hid_t group) {
    return values_of<WholeNumbers>(table, name, group, "whole numbers");
}

}  // namespace trocar
