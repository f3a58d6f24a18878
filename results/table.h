#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "results/hdf5_data.h"
#include "results/record.h"

namespace trocar {

/// @{
/// The values of a column, a kind each.
using Texts = std::vector<std::string>;
using WholeNumbers = std::vector<std::int64_t>;
using Figures = std::vector<double>;
/// @}

/// A named column of a table, all its values of one kind.
struct Column {
    hdf5::Label label;
    std::variant<Texts, WholeNumbers, Figures> values;
};

/// Columns of the same length: a group of the file with one dataset of one dimension for each.
struct Table {
    std::vector<Column> columns;
    std::size_t rows = 0;

    /// The column of that name, or nullptr.
    [[nodiscard]] const Column* find(const std::string& name) const;

    /// Drops the column of that name when there is one.
    void erase(const std::string& name);
};

/// A table of one row.
Table table_of(const std::vector<Cell>& cells);

/// Writes each column as a dataset of the group.
void write_table(hid_t group, const Table& table);

/// Reads one dataset of the group.
Column read_column(hid_t group, const std::string& name);

/// @{
/// Throws StoreError when the group holds anything but columns of one length.
Table read_table(hid_t group);
/// Only those of these columns that are there.
Table read_table(hid_t group, std::span<const char* const> names);
/// @}

/// @{
/// The texts, or whole numbers, of a column that has to be there. `group` is where the table was read, for
/// the message of the StoreError.
const Texts& texts(const Table& table, const std::string& name, hid_t group);
const WholeNumbers& whole_numbers(const Table& table, const std::string& name, hid_t group);
/// @}

/// Makes `scale` the dimension that every other column of the group is measured along, so that xarray reads
/// the group as one table.
void attach_to_dimension(hid_t group, const std::string& scale);

}  // namespace trocar
