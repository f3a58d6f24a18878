#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results/hdf5_data.h"
#include "results/store.h"
#include "results/table.h"

namespace trocar {

/// A test with an empty folder of its own, removed afterwards.
class StoreTest : public testing::Test {
  protected:
    StoreTest();
    ~StoreTest() override;

    /// A file of this name in the test's folder.
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

    /// Writes sample_case(case_id) with these rows of /states as <case_id>.h5 and returns where it is.
    [[nodiscard]] std::filesystem::path written(const std::string& case_id,
                                                const std::vector<std::vector<Cell>>& states = {}) const;

    /// The names in the test's folder, sorted.
    [[nodiscard]] std::vector<std::string> files() const;

  private:
    std::filesystem::path folder_;
};

CampaignHeader sample_header();

/// Three steps, two series, the first with a NaN and why; a text, a whole number, a figure and a NaN among
/// the cells; no states, no replay.
CaseRecord sample_case(const std::string& case_id);

/// A row of /states: a whole number, a text and a figure.
std::vector<Cell> sample_state(std::int64_t step, const std::string& strategy, double drag);

/// A tetrahedron that a triangle moves through, over `steps` steps; numbers differ from step to step.
Replay sample_replay(std::size_t steps);

std::string bytes_of(const std::filesystem::path& file);

/// The table in a group of a result file.
Table table_in(const std::filesystem::path& file, const std::string& group);

/// The names of its columns, in their order.
std::vector<std::string> column_names(const Table& table);

/// The values of a column, which must be there and of this kind.
template <class Values>
Values values(const Table& table, const std::string& column) {
    return std::get<Values>(table.find(column)->values);
}

/// All numbers of a dataset, and its shape in `shape`.
std::vector<double> numbers_in(const std::filesystem::path& file, const std::string& dataset,
                               hdf5::Shape& shape);

/// The text attribute `missing` of a dataset; nothing when it has none.
std::optional<std::string> missing_in(const std::filesystem::path& file, const std::string& dataset);

/// What `action` throws as StoreError; "nothing thrown" otherwise.
template <class Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const StoreError& error) {
        return error.what();
    }
    return "nothing thrown";
}

}  // namespace trocar
