#include <cmath>
#include <thread>

#include <gmock/gmock.h>

#include "tests/results/sample.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;
using testing::Pointwise;

class WriteTest : public StoreTest {};

TEST_F(WriteTest, EveryKindOfCellComesBack) {
    const Table cases = table_in(written("a1"), "cases");
    EXPECT_THAT(column_names(cases), ElementsAre("case_id", "build_id", "strategy", "options", "seed",
                                                 "speed", "depth_max_d_max", "status", "provenance_row"));
    EXPECT_EQ(values<Texts>(cases, "case_id"), Texts{"a1"});
    EXPECT_EQ(values<Texts>(cases, "build_id"), Texts{"b1"});
    EXPECT_EQ(values<Texts>(cases, "options"), Texts{R"({"ε": 0.7071})"});
    EXPECT_EQ(values<Texts>(cases, "status"), Texts{"timed_out"});
    EXPECT_EQ(values<WholeNumbers>(cases, "seed"), WholeNumbers{std::int64_t{1} << 62});
    EXPECT_EQ(values<Figures>(cases, "speed"), Figures{0.1});
    EXPECT_TRUE(std::isnan(values<Figures>(cases, "depth_max_d_max").at(0)));
    EXPECT_EQ(cases.find("speed")->label.units, "mm/s");
    EXPECT_EQ(cases.find("speed")->label.long_name, "tool speed");
}

TEST_F(WriteTest, ProvenanceCoversItsCase) {
    const Table provenance = table_in(written("a1"), "provenance");
    EXPECT_EQ(values<Texts>(provenance, "host"), Texts{"theatre"});
    EXPECT_EQ(values<WholeNumbers>(provenance, "cores"), WholeNumbers{2});
    EXPECT_EQ(values<WholeNumbers>(provenance, "cases"), WholeNumbers{1});
}

TEST_F(WriteTest, SeriesComeBack) {
    const auto file = written("a1");
    const CaseRecord record = sample_case("a1");
    hdf5::Shape shape;
    EXPECT_EQ(numbers_in(file, "series/a1/time", shape), record.time);
    EXPECT_THAT(numbers_in(file, "series/a1/depth_max_d", shape),
                Pointwise(NanSensitiveDoubleEq(), record.series[0].values));
    EXPECT_EQ(numbers_in(file, "series/a1/recovery", shape), Figures{});
}

TEST_F(WriteTest, SeriesTellWhyValuesAreMissing) {
    const auto file = written("a1");
    EXPECT_EQ(missing_in(file, "series/a1/depth_max_d"), R"({"no vertex inside":[[1,1]]})");
    EXPECT_EQ(missing_in(file, "series/a1/recovery"), std::nullopt);
    EXPECT_EQ(missing_in(file, "series/a1/time"), std::nullopt);
}

TEST_F(WriteTest, ContentsTellHeaderAndCases) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    write_case(path("a1.h5"), sample_header(), record);
    const Contents contents = read_contents(path("a1.h5"));
    EXPECT_EQ(contents.header.created_utc, sample_header().created_utc);
    EXPECT_EQ(contents.header.generator, sample_header().generator);
    EXPECT_EQ(contents.header.sweep_toml, sample_header().sweep_toml);
    EXPECT_EQ(contents.header.sweep_hash, sample_header().sweep_hash);
    ASSERT_EQ(contents.cases.size(), 1U);
    EXPECT_EQ(contents.cases[0].case_id, "a1");
    EXPECT_EQ(contents.cases[0].build_id, "b1");
    EXPECT_EQ(contents.cases[0].status, "timed_out");
    EXPECT_TRUE(contents.cases[0].has_replay);
    EXPECT_FALSE(read_contents(written("a2")).cases[0].has_replay);
}

TEST_F(WriteTest, ContentsTellWhatWasMeasured) {
    CaseRecord record = sample_case("a1");
    record.cells.push_back({"metrics", "", "metrics that were on", "drag,depth_max"});
    write_case(path("a1.h5"), sample_header(), record);
    const Contents::Case said = read_contents(path("a1.h5")).cases.at(0);
    EXPECT_EQ(said.metrics, "drag,depth_max");
    const Contents::Case silent = read_contents(written("a2")).cases.at(0);
    EXPECT_EQ(silent.metrics, "");
}

TEST_F(WriteTest, ReplayComesBackStepByStep) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    write_case(path("a1.h5"), sample_header(), record);
    const auto at = [&](const char* name, const hdf5::Shape& expected) {
        hdf5::Shape shape;
        auto numbers = numbers_in(path("a1.h5"), std::string("replay/a1/") + name, shape);
        EXPECT_EQ(shape, expected) << name;
        return numbers;
    };
    for (const std::size_t k : {0U, 1U, 2U}) {
        const auto step = static_cast<double>(k);
        EXPECT_EQ(at("found", {3, 4, 3}).at(12 * k), 100 + step);
        EXPECT_EQ(at("handled", {3, 4, 3}).at(12 * k + 4), 200 + step);
        EXPECT_EQ(at("deformed", {3, 4, 3}).at(12 * k + 11), 300 + step);
        EXPECT_EQ(at("tool_pose", {3, 4, 4}).at(16 * k + 11), step);
    }
    EXPECT_EQ(at("tool_start", {4, 4}), (Figures{0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, -5, 0, 0, 0, 1}));
    EXPECT_EQ(at("facets", {4, 3}), (Figures{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
    EXPECT_EQ(at("rest_positions", {4, 3}), (Figures{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(at("tool_facets", {1, 3}), (Figures{0, 1, 2}));
    EXPECT_EQ(at("tool_positions", {3, 3}), (Figures{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(at("moved", {3}), (Figures{1, 2, 2}));
    EXPECT_EQ(at("moved_by", {3, 3}), (Figures{0.1, -2, 1, 0.1, -2, 2, 0.1, -2, 2}));
    EXPECT_EQ(at("moved_offsets", {4}), (Figures{0, 0, 1, 3}));
}

TEST_F(WriteTest, ToolIsPlacedByItsPose) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    write_case(path("a1.h5"), sample_header(), record);
    hdf5::Shape shape;
    const auto placed = numbers_in(path("a1.h5"), "replay/a1/tool_placed", shape);
    EXPECT_EQ(shape, (hdf5::Shape{3, 3, 3}));
    // The quarter turn brings x to y and y to −x; the shift is (10, 20, step).
    EXPECT_EQ(Figures(placed.end() - 9, placed.end()), (Figures{10, 20, 2, 10, 21, 2, 9, 20, 2}));
}

TEST_F(WriteTest, ACaseThatTookNoStepIsStored) {
    CaseRecord record = sample_case("a1");
    record.time.clear();
    record.series = {{"depth_max_d", "mm", "greatest depth", {}, ""}};
    record.replay = Replay{};
    write_case(path("a1.h5"), sample_header(), record);
    EXPECT_TRUE(read_contents(path("a1.h5")).cases.at(0).has_replay);
}

TEST_F(WriteTest, SameRecordGivesSameBytes) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    record.states = {sample_state(1, "tool-facet", 0.5)};
    write_case(path("first.h5"), sample_header(), record);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's times count seconds
    write_case(path("second.h5"), sample_header(), record);
    EXPECT_EQ(bytes_of(path("first.h5")), bytes_of(path("second.h5")));
}

TEST_F(WriteTest, OnlyTheFinalNameIsLeft) {
    EXPECT_EQ(written("a1"), path("a1.h5"));
    EXPECT_EQ(written("a1"), path("a1.h5"));
    EXPECT_THAT(files(), ElementsAre("a1.h5"));
}

TEST_F(WriteTest, SeveralThreadsWriteAtOnce) {
    std::vector<std::jthread> threads;
    for (const auto* id : {"a1", "a2", "a3", "a4"}) {
        threads.emplace_back([this, id] { EXPECT_EQ(read_contents(written(id)).cases.at(0).case_id, id); });
    }
    threads.clear();
    EXPECT_THAT(files(), ElementsAre("a1.h5", "a2.h5", "a3.h5", "a4.h5"));
}

}  // namespace
}  // namespace trocar
