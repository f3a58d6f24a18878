#include "results/table_merger.h"

#include <limits>

#include <fmt/format.h>

#include "results/store.h"

namespace trocar {
namespace {

template <class T>
const T missing{};
template <>
const double missing<double> = std::numeric_limits<double>::quiet_NaN();

/// Lengthens a column to `rows`.
void fill(Column& column, std::size_t rows) {
    std::visit(
        [&]<class T>(std::vector<T>& values) {
            if (values.size() < rows) values.resize(rows, missing<T>);
        },
        column.values);
}

void make_figures(Column& column) {
    const auto* whole = std::get_if<WholeNumbers>(&column.values);
    if (whole != nullptr) column.values = Figures(whole->begin(), whole->end());
}

bool holds_text(const Column& column) { return std::holds_alternative<Texts>(column.values); }

void append_rows(Column& to, const Column& from, std::span<const std::size_t> rows) {
    std::visit(
        [&]<class To, class From>(std::vector<To>& target, const std::vector<From>& source) {
            if constexpr (std::is_convertible_v<From, To>) {
                for (const std::size_t row : rows) target.push_back(static_cast<To>(source[row]));
            }
        },
        to.values, from.values);
}

}  // namespace

TableMerger::Merged& TableMerger::prepare(const Column& column, const std::string& source) {
    const auto& name = column.label.name;
    const auto [position, is_new] = index_.try_emplace(name, columns_.size());
    if (is_new) {
        columns_.push_back({.column = {.label = column.label, .values = {}}, .source = source});
        std::visit([&]<class T>(const std::vector<T>&) { columns_.back().column.values = std::vector<T>(); },
                   column.values);
    }
    Merged& merged = columns_[position->second];
    if (holds_text(merged.column) != holds_text(column)) {
        throw StoreError(fmt::format("{}: column {} holds {}, but {} in {}; merge only files of one version",
                                     source, name, holds_text(column) ? "text" : "numbers",
                                     holds_text(column) ? "numbers" : "text", merged.source));
    }
    if (merged.column.label.units != column.label.units) {
        throw StoreError(
            fmt::format("{}: column {} has the unit \"{}\", but \"{}\" in {}; merge only files of one "
                        "version",
                        source, name, column.label.units, merged.column.label.units, merged.source));
    }
    fill(merged.column, rows_);
    if (std::holds_alternative<Figures>(column.values)) make_figures(merged.column);
    return merged;
}

void TableMerger::append(const Table& part, std::span<const std::size_t> rows, const std::string& source) {
    for (const Column& column : part.columns) append_rows(prepare(column, source).column, column, rows);
    rows_ += rows.size();
    for (Merged& merged : columns_) fill(merged.column, rows_);
}

Table TableMerger::in_order(std::span<const std::size_t> order) const {
    Table result{.columns = {}, .rows = order.size()};
    for (const Merged& merged : columns_) {
        Column column{.label = merged.column.label, .values = {}};
        std::visit(
            [&]<class T>(const std::vector<T>& values) {
                std::vector<T> ordered;
                for (const std::size_t row : order) ordered.push_back(values[row]);
                column.values = std::move(ordered);
            },
            merged.column.values);
        result.columns.push_back(std::move(column));
    }
    return result;
}

}  // namespace trocar
