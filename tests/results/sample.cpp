#include "tests/results/sample.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

namespace trocar {

StoreTest::StoreTest() : folder_(std::filesystem::temp_directory_path() / "trocar-store-XXXXXX") {
    std::string pattern = folder_.string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
}

StoreTest::~StoreTest() { std::filesystem::remove_all(folder_); }

std::filesystem::path StoreTest::written(const std::string& case_id,
                                         const std::vector<std::vector<Cell>>& states) const {
    CaseRecord record = sample_case(case_id);
    record.states = states;
    write_case(path(case_id + ".h5"), sample_header(), record);
    return path(case_id + ".h5");
}

std::vector<std::string> StoreTest::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
        names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
}

CampaignHeader sample_header() {
    return {.created_utc = "2024-05-01T12:00:00Z",
            .generator = "trocar test",
            .sweep_toml = "[sweep]\nname = \"µ test\"\n",
            .sweep_hash = "5eed"};
}

CaseRecord sample_case(const std::string& case_id) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {.case_id = case_id,
            .build_id = "b1",
            .cells = {{"strategy", "", "strategy", "nearest-face"},
                      {"options", "", "options as JSON", R"({"ε": 0.7071})"},
                      {"seed", "1", "seed", std::int64_t{1} << 62},
                      {"speed", "mm/s", "tool speed", 0.1},
                      {"depth_max_d_max", "mm", "greatest depth", nan},
                      {"status", "", "how the case ended", std::string(status_name(CaseStatus::timed_out))}},
            .time = {0.1, 0.2, 0.3},
            .series =
                {{"depth_max_d", "mm", "greatest depth", {1.5, nan, 0.25}, R"({"no vertex inside":[[1,1]]})"},
                 {"recovery", "mm", "distance to rest", {}, ""}},
            .states = {},
            .replay = {},
            .provenance = {{"host", "", "machine", "theatre"}, {"cores", "1", "cores", std::int64_t{2}}}};
}

std::vector<Cell> sample_state(std::int64_t step, const std::string& strategy, double drag) {
    return {{"step", "1", "step in which the state was found", step},
            {"strategy", "", "strategy that answered", strategy},
            {"drag", "mm", "sideways displacement", drag}};
}

Replay sample_replay(std::size_t steps) {
    Replay replay{.facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                  .rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  .tool_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                  .tool_facets = {{0, 1, 2}},
                  .tool_start = {0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, -5, 0, 0, 0, 1},
                  .steps = {}};
    for (std::size_t k = 0; k < steps; ++k) {
        const auto at = static_cast<float>(k);
        // A quarter turn about z, then a shift along z that grows with the steps.
        ReplayStep step{.found = replay.rest_positions,
                        .handled = replay.rest_positions,
                        .deformed = replay.rest_positions,
                        .tool_pose = {0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, at, 0, 0, 0, 1},
                        .moved = std::vector<std::int32_t>(k, static_cast<std::int32_t>(k)),
                        .moved_by = std::vector<std::array<double, 3>>(k, {0.1, -2, static_cast<double>(k)})};
        step.found[0][0] = 100 + at;
        step.handled[1][1] = 200 + at;
        step.deformed[3][2] = 300 + at;
        replay.steps.push_back(step);
    }
    return replay;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Table table_in(const std::filesystem::path& file, const std::string& group) {
    const hdf5::Session session;
    const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    return read_table(hdf5::open_group(open.id(), group).id());
}

std::vector<std::string> column_names(const Table& table) {
    std::vector<std::string> names;
    for (const Column& column : table.columns) names.push_back(column.label.name);
    return names;
}

std::vector<double> numbers_in(const std::filesystem::path& file, const std::string& dataset,
                               hdf5::Shape& shape) {
    const hdf5::Session session;
    const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const hdf5::Dataset source = hdf5::open_dataset(open.id(), dataset);
    shape = hdf5::shape_of(source.id());
    std::vector<double> numbers(std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies{}));
    hdf5::checked(H5Dread(source.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
                  source.id(), "", "cannot read");
    return numbers;
}

std::optional<std::string> missing_in(const std::filesystem::path& file, const std::string& dataset) {
    const hdf5::Session session;
    const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const hdf5::Dataset source = hdf5::open_dataset(open.id(), dataset);
    if (H5Aexists(source.id(), "missing") <= 0) return std::nullopt;
    return hdf5::read_text_attribute(source.id(), "missing");
}

}  // namespace trocar
