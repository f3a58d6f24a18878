#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "results/table.h"

namespace trocar {

/// Puts rows of several tables under one another. The result has every column that one of the tables has, in
/// the order of first appearance; what a row's table lacks is NaN, "" or 0. A column that holds whole numbers
/// here and figures there becomes figures.
class TableMerger {
  public:
    /// Appends `rows` of `part`. Throws StoreError, naming `source` and the file it disagrees with, when a
    /// column is text in one and numbers in the other, or its units differ.
    void append(const Table& part, std::span<const std::size_t> rows, const std::string& source);

    [[nodiscard]] std::size_t rows() const { return rows_; }

    /// The rows appended so far, in this order.
    [[nodiscard]] Table in_order(std::span<const std::size_t> order) const;

  private:
    struct Merged {
        Column column;
        std::string source;  ///< where it first appeared
    };

    /// The column to append `column` to, filled up to rows_ and of a kind that takes its values.
    Merged& prepare(const Column& column, const std::string& source);

    std::vector<Merged> columns_;
    std::map<std::string, std::size_t> index_;  ///< name → position in columns_
    std::size_t rows_ = 0;
};

}  // namespace trocar
