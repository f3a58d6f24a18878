#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/results/sample.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MergeTest : public StoreTest {
  protected:
    void merge_all(const std::vector<Part>& parts, const std::vector<std::string>& order) const {
        merge(path("all.h5"), sample_header(), parts, order);
    }

    [[nodiscard]] Texts merged_ids() const {
        return values<Texts>(table_in(path("all.h5"), "cases"), "case_id");
    }
};

Cell& cell(CaseRecord& record, const std::string& name) {
    return *std::ranges::find(record.cells, name, &Cell::name);
}

TEST_F(MergeTest, CasesFollowTheOrder) {
    merge_all({{written("a1"), {}}, {written("a2"), {}}, {written("a3"), {}}}, {"a3", "a1", "a2"});
    EXPECT_EQ(merged_ids(), (Texts{"a3", "a1", "a2"}));
    EXPECT_THAT(files(), ElementsAre("a1.h5", "a2.h5", "a3.h5", "all.h5"));
}

TEST_F(MergeTest, SeriesAndReplaysAreCopied) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    write_case(path("a1.h5"), sample_header(), record);
    merge_all({{path("a1.h5"), {}}, {written("a2"), {}}}, {"a1", "a2"});
    const Contents contents = read_contents(path("all.h5"));
    EXPECT_TRUE(contents.cases.at(0).has_replay);
    EXPECT_FALSE(contents.cases.at(1).has_replay);
    for (const auto* dataset : {"series/a1/time", "replay/a1/found", "replay/a1/moved"}) {
        hdf5::Shape before, after;
        EXPECT_EQ(numbers_in(path("a1.h5"), dataset, before), numbers_in(path("all.h5"), dataset, after))
            << dataset;
        EXPECT_EQ(before, after) << dataset;
    }
    hdf5::Shape shape;
    EXPECT_EQ(numbers_in(path("all.h5"), "series/a2/time", shape), sample_case("a2").time);
}

TEST_F(MergeTest, WhyValuesAreMissingIsCopied) {
    CaseRecord record = sample_case("a2");
    record.series[0].missing = std::string(200'000, 'x');  // more than fits into a dataset's header
    write_case(path("a2.h5"), sample_header(), record);
    merge_all({{written("a1"), {}}, {path("a2.h5"), {}}}, {"a1", "a2"});
    EXPECT_EQ(missing_in(path("all.h5"), "series/a1/depth_max_d"), R"({"no vertex inside":[[1,1]]})");
    EXPECT_EQ(missing_in(path("all.h5"), "series/a1/recovery"), std::nullopt);
    EXPECT_EQ(missing_in(path("all.h5"), "series/a2/depth_max_d"), record.series[0].missing);
}

TEST_F(MergeTest, ACampaignTakesInFurtherCases) {
    merge_all({{written("a1"), {}}, {written("a3"), {}}}, {"a1", "a3"});
    merge_all({{path("all.h5"), {}}, {written("a2"), {}}}, {"a1", "a2", "a3"});
    EXPECT_EQ(merged_ids(), (Texts{"a1", "a2", "a3"}));
    hdf5::Shape shape;
    for (const auto* id : {"a1", "a2", "a3"}) {
        EXPECT_EQ(numbers_in(path("all.h5"), fmt::format("series/{}/time", id), shape).size(), 3U);
    }
}

TEST_F(MergeTest, ManyCasesComeOutOfOneFile) {
    std::vector<Part> parts;
    std::vector<std::string> order;
    for (int i = 0; i < 150; ++i) {
        order.push_back(fmt::format("c{}", i));
        parts.push_back({written(order.back()), {}});
    }
    merge_all(parts, order);
    merge_all({{path("all.h5"), {}}}, order);
    hdf5::Shape shape;
    for (const std::string& id : order) {
        EXPECT_EQ(numbers_in(path("all.h5"), fmt::format("series/{}/time", id), shape), sample_case(id).time)
            << id;
    }
}

TEST_F(MergeTest, OnlyChosenCasesAreTaken) {
    merge_all({{written("a1"), {}}, {written("a2"), {}}}, {"a1", "a2"});
    CaseRecord newer = sample_case("a1");
    newer.build_id = "b2";
    write_case(path("a1.h5"), sample_header(), newer);
    merge_all({{path("all.h5"), {"a2"}}, {path("a1.h5"), {}}}, {"a1", "a2"});
    EXPECT_EQ(values<Texts>(table_in(path("all.h5"), "cases"), "build_id"), (Texts{"b2", "b1"}));
}

TEST_F(MergeTest, MergingAgainGivesTheSameBytes) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    record.states = {sample_state(1, "s", 1)};
    write_case(path("a1.h5"), sample_header(), record);
    const std::vector<Part> parts{{path("a1.h5"), {}}, {written("a2"), {}}};
    merge_all(parts, {"a1", "a2"});
    const std::string first = bytes_of(path("all.h5"));
    merge_all(parts, {"a1", "a2"});
    EXPECT_EQ(first, bytes_of(path("all.h5")));
    merge_all({{path("all.h5"), {}}}, {"a1", "a2"});
    EXPECT_EQ(first, bytes_of(path("all.h5")));
}

TEST_F(MergeTest, MissingColumnsAreFilled) {
    CaseRecord richer = sample_case("a2");
    richer.cells.push_back({"figure", "mm", "a figure", 2.5});
    richer.cells.push_back({"count", "1", "a count", std::int64_t{7}});
    richer.cells.push_back({"note", "", "a note", "yes"});
    write_case(path("a2.h5"), sample_header(), richer);
    merge_all({{written("a1"), {}}, {path("a2.h5"), {}}, {written("a3"), {}}}, {"a1", "a2", "a3"});
    const Table cases = table_in(path("all.h5"), "cases");
    const auto figures = values<Figures>(cases, "figure");
    EXPECT_TRUE(std::isnan(figures.at(0)) && std::isnan(figures.at(2)));
    EXPECT_EQ(figures.at(1), 2.5);
    EXPECT_EQ(values<WholeNumbers>(cases, "count"), (WholeNumbers{0, 7, 0}));
    EXPECT_EQ(values<Texts>(cases, "note"), (Texts{"", "yes", ""}));
}

TEST_F(MergeTest, WholeNumbersAndFiguresBecomeFigures) {
    CaseRecord record = sample_case("a2");
    cell(record, "speed").value = std::int64_t{20};
    write_case(path("a2.h5"), sample_header(), record);
    const Part one{written("a1"), {}}, other{path("a2.h5"), {}};
    merge_all({one, other}, {"a1", "a2"});
    EXPECT_EQ(values<Figures>(table_in(path("all.h5"), "cases"), "speed"), (Figures{0.1, 20}));
    merge_all({other, one}, {"a1", "a2"});
    EXPECT_EQ(values<Figures>(table_in(path("all.h5"), "cases"), "speed"), (Figures{0.1, 20}));
}

TEST_F(MergeTest, EqualProvenanceIsOneRow) {
    CaseRecord elsewhere = sample_case("a2");
    elsewhere.provenance[0].value = "ward";
    write_case(path("a2.h5"), sample_header(), elsewhere);
    merge_all({{written("a1"), {}}, {path("a2.h5"), {}}, {written("a3"), {}}}, {"a1", "a2", "a3"});
    for (const auto* pass : {"parts", "the campaign itself"}) {
        const Table provenance = table_in(path("all.h5"), "provenance");
        EXPECT_EQ(values<Texts>(provenance, "host"), (Texts{"theatre", "ward"})) << pass;
        EXPECT_EQ(values<WholeNumbers>(provenance, "cases"), (WholeNumbers{2, 1})) << pass;
        EXPECT_EQ(values<WholeNumbers>(table_in(path("all.h5"), "cases"), "provenance_row"),
                  (WholeNumbers{0, 1, 0}))
            << pass;
        merge_all({{path("all.h5"), {}}}, {"a1", "a2", "a3"});
    }
    merge_all({{path("all.h5"), {"a2"}}}, {"a2"});
    EXPECT_EQ(values<Texts>(table_in(path("all.h5"), "provenance"), "host"), Texts{"ward"});
}

TEST_F(MergeTest, RefusesAnotherSweepNamingTheFile) {
    CampaignHeader other = sample_header();
    other.sweep_hash = "0ther";
    write_case(path("other.h5"), other, sample_case("a2"));
    const auto error = error_of([&] {
        merge_all({{written("a1"), {}}, {path("other.h5"), {}}}, {"a1", "a2"});
    });
    EXPECT_THAT(error, HasSubstr(path("other.h5").string() +
                                 ": comes from another sweep (hash 0ther, expected 5eed)"));
    EXPECT_THAT(files(), ElementsAre("a1.h5", "other.h5"));
}

TEST_F(MergeTest, RefusesColumnsThatDisagreeNamingBothFiles) {
    const Part good{written("a1"), {}};
    CaseRecord record = sample_case("a2");
    cell(record, "speed").units = "m/s";
    write_case(path("a2.h5"), sample_header(), record);
    auto error = error_of([&] { merge_all({good, {path("a2.h5"), {}}}, {"a1", "a2"}); });
    EXPECT_THAT(error, HasSubstr("a2.h5: column speed has the unit \"m/s\", but \"mm/s\" in"));
    EXPECT_THAT(error, HasSubstr("a1.h5"));
    cell(record, "speed") = {"speed", "mm/s", "tool speed", "fast"};
    write_case(path("a2.h5"), sample_header(), record);
    error = error_of([&] { merge_all({good, {path("a2.h5"), {}}}, {"a1", "a2"}); });
    EXPECT_THAT(error, HasSubstr("a2.h5: column speed holds text, but numbers in"));
}

TEST_F(MergeTest, RefusesWhatTheOrderAndThePartsDoNotAgreeOn) {
    const Part a1{written("a1"), {}}, a2{written("a2"), {}};
    const auto error = [&](const std::vector<Part>& parts, const std::vector<std::string>& order) {
        return error_of([&] { merge_all(parts, order); });
    };
    EXPECT_THAT(error({a1}, {"a1", "a2"}), HasSubstr("no part holds case a2"));
    EXPECT_THAT(error({a1}, {"a1", "a1"}), HasSubstr("names it twice"));
    EXPECT_THAT(error({a1, a2}, {"a1"}), HasSubstr("the order does not name case a2"));
    EXPECT_THAT(error({a1, a1}, {"a1"}), HasSubstr("holds case a1, which was found before"));
    EXPECT_THAT(error({{a1.file, {"a1", "a7"}}}, {"a1", "a7"}), HasSubstr("holds 1 of the 2 cases"));
    EXPECT_THAT(error({}, {}), HasSubstr("there are no cases"));
    EXPECT_THAT(files(), ElementsAre("a1.h5", "a2.h5"));
}

}  // namespace
}  // namespace trocar
