#include <cmath>
#include <utility>

#include <gmock/gmock.h>

#include "tests/results/sample.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StatesTest : public StoreTest {
  protected:
    void merge_all(const std::vector<Part>& parts, const std::vector<std::string>& order) const {
        merge(path("all.h5"), sample_header(), parts, order);
    }
};

TEST_F(StatesTest, WithoutStatesTheirGroupIsEmpty) {
    EXPECT_THAT(column_names(table_in(written("a1"), "states")), ElementsAre());
}

TEST_F(StatesTest, StatesComeBackNumberedAndWithTheirRun) {
    const auto file =
        written("a1", {sample_state(3, "tool-facet", 0.5), sample_state(3, "nearest-face", 0.25)});
    const Table states = table_in(file, "states");
    EXPECT_THAT(column_names(states), ElementsAre("state", "case_id", "step", "strategy", "drag"));
    EXPECT_EQ(values<WholeNumbers>(states, "state"), (WholeNumbers{0, 1}));
    EXPECT_EQ(values<Texts>(states, "case_id"), (Texts{"a1", "a1"}));
    EXPECT_EQ(values<WholeNumbers>(states, "step"), (WholeNumbers{3, 3}));
    EXPECT_EQ(values<Texts>(states, "strategy"), (Texts{"tool-facet", "nearest-face"}));
    EXPECT_EQ(values<Figures>(states, "drag"), (Figures{0.5, 0.25}));
    EXPECT_EQ(states.find("drag")->label.units, "mm");
    EXPECT_EQ(states.find("drag")->label.long_name, "sideways displacement");
}

TEST_F(StatesTest, StatesFollowTheCasesAndKeepTheirOrder) {
    const Part a1{written("a1", {sample_state(4, "s", 1), sample_state(2, "t", 2)}), {}};
    const Part a3{written("a3", {sample_state(9, "s", 3)}), {}};
    merge_all({a1, {written("a2"), {}}, a3}, {"a3", "a2", "a1"});
    for (const auto* pass : {"parts", "the campaign itself"}) {
        const Table states = table_in(path("all.h5"), "states");
        EXPECT_EQ(states.columns.size(), 5U) << pass;
        EXPECT_EQ(values<WholeNumbers>(states, "state"), (WholeNumbers{0, 1, 2})) << pass;
        EXPECT_EQ(values<Texts>(states, "case_id"), (Texts{"a3", "a1", "a1"})) << pass;
        EXPECT_EQ(values<WholeNumbers>(states, "step"), (WholeNumbers{9, 4, 2})) << pass;
        EXPECT_EQ(values<Texts>(states, "strategy"), (Texts{"s", "s", "t"})) << pass;
        EXPECT_EQ(values<Figures>(states, "drag"), (Figures{3, 1, 2})) << pass;
        merge_all({{path("all.h5"), {}}}, {"a3", "a2", "a1"});
    }
}

TEST_F(StatesTest, ColumnsOfStatesAreUnited) {
    std::vector<Cell> row = sample_state(1, "s", 1);
    row.push_back({"gap_h", "mm", "a gap", 0.5});
    row.push_back({"note", "", "a note", "yes"});
    merge_all({{written("a2", {sample_state(2, "t", 2)}), {}}, {written("a1", {row}), {}}}, {"a2", "a1"});
    const Table states = table_in(path("all.h5"), "states");
    const auto gaps = values<Figures>(states, "gap_h");
    EXPECT_TRUE(std::isnan(gaps.at(0)));
    EXPECT_EQ(gaps.at(1), 0.5);
    EXPECT_EQ(values<Texts>(states, "note"), (Texts{"", "yes"}));
}

TEST_F(StatesTest, StatesOfCasesThatAreNotTakenAreLeftBehind) {
    merge_all(
        {{written("a1", {sample_state(1, "s", 1)}), {}}, {written("a2", {sample_state(2, "s", 2)}), {}}},
        {"a1", "a2"});
    const Part newer{written("a1", {sample_state(7, "s", 7)}), {}};
    merge_all({{path("all.h5"), {"a2"}}, newer}, {"a1", "a2"});
    EXPECT_EQ(values<WholeNumbers>(table_in(path("all.h5"), "states"), "step"), (WholeNumbers{7, 2}));
    merge_all({{path("all.h5"), {"a1"}}, {written("a2"), {}}}, {"a1", "a2"});
    EXPECT_EQ(values<WholeNumbers>(table_in(path("all.h5"), "states"), "step"), WholeNumbers{7});
    merge_all({{path("all.h5"), {"a2"}}}, {"a2"});
    EXPECT_TRUE(table_in(path("all.h5"), "states").columns.empty());
}

TEST_F(StatesTest, UnitsThatDisagreeAreRefused) {
    std::vector<Cell> metres = sample_state(1, "s", 1);
    metres.back().units = "m";
    const Part good{written("a1", {sample_state(1, "s", 1)}), {}}, other{written("a2", {metres}), {}};
    EXPECT_THAT(error_of([&] {
                    merge_all({good, other}, {"a1", "a2"});
                }),
                HasSubstr("a2.h5: column drag has the unit \"m\", but \"mm\" in"));
}

TEST_F(StatesTest, StatesThatCannotBeStored) {
    const auto error_after = [&](auto change) {
        std::vector<std::vector<Cell>> states{sample_state(1, "s", 1), sample_state(1, "t", 2)};
        change(states.back());
        return error_of([&] { (void)written("a1", states); });
    };
    const auto differs = HasSubstr("a1.h5: not written: state 1 has not the columns of the first");
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { row.pop_back(); }), differs);
    EXPECT_THAT(error_after([](std::vector<Cell>& row) {
                    row.push_back({"gap", "mm", "a gap", 1.0});
                }),
                differs);
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { std::swap(row[0], row[1]); }), differs);
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { row[2].units = "m"; }), differs);
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { row[2].value = std::int64_t{2}; }), differs);
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { row[2].name = "a/b"; }),
                HasSubstr("\"a/b\" cannot name"));
    EXPECT_THAT(error_after([](std::vector<Cell>& row) { row[1].value = std::string("a\0b", 3); }),
                HasSubstr("zero byte"));
    EXPECT_THAT(error_of([&] {
                    (void)written("a1", {{{"case_id", "", "a second one", "a1"}}});
                }),
                HasSubstr("/states/case_id"));
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(StatesTest, DamagedStates) {
    const auto merging_after = [&](auto change) {
        const auto file = written("a1", {sample_state(1, "s", 1)});
        {
            const hdf5::Session session;
            const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
            change(open.id());
        }
        return error_of([&] { merge_all({{file, {}}}, {"a1"}); });
    };
    EXPECT_THAT(merging_after([](hid_t open) { H5Ldelete(open, "states", H5P_DEFAULT); }),
                HasSubstr("a1.h5: /states: cannot open the group"));
    EXPECT_THAT(merging_after([](hid_t open) { H5Ldelete(open, "states/case_id", H5P_DEFAULT); }),
                HasSubstr("a1.h5: /states/case_id: the column is missing"));
    EXPECT_THAT(merging_after([](hid_t open) {
                    const hdf5::Group states = hdf5::open_group(open, "states");
                    hdf5::create_dataset(states.id(), {"odd", "1", "odd"}, H5T_IEEE_F64LE, {2});
                }),
                HasSubstr("/states/odd: expected 1 rows as in state, found 2"));
    EXPECT_THAT(merging_after([](hid_t) {}), "nothing thrown");
}

}  // namespace
}  // namespace trocar
