#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/resource.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif
#include <unistd.h>

#include "results/xdmf.h"
#include "tests/results/sample.h"

namespace trocar {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RefusalTest : public StoreTest {
  protected:
    /// A good file after `change` to it, given the open file.
    template <class Change>
    [[nodiscard]] std::filesystem::path changed(Change change) const {
        auto file = written("a1");
        const hdf5::Session session;
        const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
        change(open.id());
        return file;
    }
};

std::string reading(const std::filesystem::path& file) {
    return error_of([&] { read_contents(file); });
}

/// libhdf5 1.10 does not free what it holds for a file that it could not close. That is no leak of ours, so
/// LeakSanitizer does not look at what is allocated while this exists.
class LeaksOfHdf5 {
  public:
    LeaksOfHdf5() { ignore(true); }
    LeaksOfHdf5(const LeaksOfHdf5&) = delete;
    LeaksOfHdf5& operator=(const LeaksOfHdf5&) = delete;
    ~LeaksOfHdf5() { ignore(false); }

  private:
    static void ignore([[maybe_unused]] bool wanted) {
#ifdef __SANITIZE_ADDRESS__
        wanted ? __lsan_disable() : __lsan_enable();
#endif
    }
};

/// No file of this process grows beyond some bytes while this exists: a disk that is full.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);  // NOLINT(cert-err33-c): what it was before is the default
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

TEST_F(RefusalTest, MissingFile) {
    EXPECT_THAT(reading(path("none.h5")),
                HasSubstr("none.h5: No such file or directory; expected a result file"));
    EXPECT_THAT(reading(path("")), HasSubstr("is not a file"));
}

TEST_F(RefusalTest, FileOfAnotherKind) {
    std::ofstream(path("text.h5")) << "case_id,strategy\n";
    EXPECT_THAT(reading(path("text.h5")),
                AllOf(HasSubstr("text.h5: "), HasSubstr("file signature not found")));
}

TEST_F(RefusalTest, HDF5FileOfAnotherProgram) {
    {
        const hdf5::Session session;
        const hdf5::File foreign(
            H5Fcreate(path("foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    }
    EXPECT_THAT(reading(path("foreign.h5")), HasSubstr("is an HDF5 file but no Trocar result file"));
}

TEST_F(RefusalTest, TruncatedFileAtAnyLength) {
    const auto whole = written("a1");
    const auto size = std::filesystem::file_size(whole);
    for (std::uintmax_t length = 0; length < size; length += size / 50) {
        std::filesystem::copy_file(whole, path("cut.h5"), std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(path("cut.h5"), length);
        EXPECT_THAT(reading(path("cut.h5")), HasSubstr("cut.h5: ")) << length << " of " << size;
    }
}

TEST_F(RefusalTest, AnotherSchemaIsRefusedByReadAndMerge) {
    const auto file = changed([](hid_t open) {
        H5Adelete(open, "schema_version");
        hdf5::write_attribute(open, "schema_version", schema_version + 1);
    });
    EXPECT_THAT(reading(file), HasSubstr("a1.h5: has schema version 3, this program reads version 2"));
    const std::vector<Part> parts{{file, {}}};
    const std::vector<std::string> order{"a1"};
    EXPECT_THAT(error_of([&] { merge(path("all.h5"), sample_header(), parts, order); }),
                HasSubstr("a1.h5: has schema version 3"));
}

TEST_F(RefusalTest, UnfinishedFile) {
    EXPECT_THAT(reading(changed([](hid_t open) { H5Adelete(open, "complete"); })), HasSubstr("is not whole"));
}

TEST_F(RefusalTest, ColumnsOfWrongShapeOrKind) {
    const auto with = [&](hid_t stored_type, const hdf5::Shape& shape) {
        const auto file = changed([&](hid_t open) {
            const hdf5::Group cases = hdf5::open_group(open, "cases");
            hdf5::create_dataset(cases.id(), {"odd", "1", "odd"}, stored_type, shape);
        });
        const std::vector<Part> parts{{.file = file, .case_ids = {}}};
        const std::vector<std::string> order{"a1"};
        return error_of([&] { merge(path("all.h5"), sample_header(), parts, order); });
    };
    EXPECT_THAT(with(H5T_IEEE_F64LE, {2}), HasSubstr("/cases/odd: expected 1 rows as in case_id, found 2"));
    EXPECT_THAT(with(H5T_IEEE_F64LE, {1, 1}), HasSubstr("/cases/odd: expected one dimension"));
    EXPECT_THAT(with(H5T_IEEE_F64LE, {hsize_t{1} << 50U}), HasSubstr("of at most 10000000 rows"));
    EXPECT_THAT(with(H5T_STD_REF_OBJ, {1}), HasSubstr("/cases/odd: expected text of variable length"));
}

TEST_F(RefusalTest, MissingColumn) {
    const auto file = changed([](hid_t open) { H5Ldelete(open, "cases/status", H5P_DEFAULT); });
    EXPECT_THAT(reading(file), HasSubstr("a1.h5: /cases/status: the column is missing"));
}

TEST_F(RefusalTest, RecordsThatCannotBeStored) {
    const auto error_after = [&](auto change) {
        CaseRecord record = sample_case("a1");
        change(record);
        return error_of([&] { write_case(path("a1.h5"), sample_header(), record); });
    };
    EXPECT_THAT(error_after([](CaseRecord& r) { r.case_id = "../a1"; }), HasSubstr("\"../a1\" cannot name"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.cells.back().value = "fine"; }), HasSubstr("status"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.cells.pop_back(); }), HasSubstr("no cell status"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.time.pop_back(); }),
                HasSubstr("the series depth_max_d has 3 values, the case 2 steps"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.cells.push_back(r.cells[0]); }),
                HasSubstr("/cases/strategy"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.cells[0].value = std::string("a\0b", 3); }),
                HasSubstr("zero byte"));
    EXPECT_THAT(error_after([](CaseRecord& r) { r.replay = sample_replay(2); }),
                HasSubstr("the replay has 2 steps, the case 3"));
    EXPECT_THAT(error_after([](CaseRecord& r) {
                    r.replay = sample_replay(3);
                    r.replay->steps[1].handled.pop_back();
                }),
                HasSubstr("has not the organ's 4 vertices"));
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(RefusalTest, FolderThatIsNotThere) {
    const auto file = path("none") / "a1.h5";
    EXPECT_THAT(error_of([&] { write_case(file, sample_header(), sample_case("a1")); }),
                AllOf(HasSubstr("cannot create the file"), HasSubstr("No such file or directory")));
}

TEST_F(RefusalTest, FolderThatIsNotWritable) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    std::filesystem::create_directory(path("locked"));
    std::filesystem::permissions(path("locked"), std::filesystem::perms::owner_read);
    EXPECT_THAT(error_of([&] { write_case(path("locked") / "a1.h5", sample_header(), sample_case("a1")); }),
                HasSubstr("Permission denied"));
}

TEST_F(RefusalTest, FinalNameThatIsAFolder) {
    std::filesystem::create_directories(path("a1.h5") / "inside");
    EXPECT_THAT(error_of([&] { write_case(path("a1.h5"), sample_header(), sample_case("a1")); }),
                HasSubstr("a1.h5: cannot give the finished file its name"));
    EXPECT_THAT(files(), ElementsAre("a1.h5"));
}

TEST_F(RefusalTest, AFullDiskLeavesNothingBehindAndTheNextWriteWorks) {
    const LeaksOfHdf5 ignored;
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    write_case(path("whole.h5"), sample_header(), record);
    const auto size = std::filesystem::file_size(path("whole.h5"));
    for (rlim_t room = 0; room < size; room += size / 20 + 1) {
        const FullDisk full(room);
        EXPECT_THAT(error_of([&] { write_case(path("a1.h5"), sample_header(), record); }),
                    HasSubstr("File too large"))
            << room << " of " << size;
    }
    EXPECT_THAT(files(), ElementsAre("whole.h5"));
    write_case(path("a1.h5"), sample_header(), record);
    EXPECT_EQ(bytes_of(path("a1.h5")), bytes_of(path("whole.h5")));
}

TEST_F(RefusalTest, AFailedMergeKeepsTheOldCampaign) {
    const LeaksOfHdf5 ignored;
    const std::vector<Part> parts{{written("a1"), {}}};
    const std::vector<std::string> order{"a1"};
    merge(path("all.h5"), sample_header(), parts, order);
    const std::string before = bytes_of(path("all.h5"));
    {
        const FullDisk full(before.size() / 2);
        EXPECT_NE(error_of([&] { merge(path("all.h5"), sample_header(), parts, order); }), "nothing thrown");
    }
    EXPECT_EQ(bytes_of(path("all.h5")), before);
    EXPECT_THAT(files(), ElementsAre("a1.h5", "all.h5"));
}

TEST_F(RefusalTest, XdmfNeedsAReplay) {
    const auto file = written("a1");
    EXPECT_THAT(error_of([&] { write_xdmf(file, path("a1.xdmf")); }), HasSubstr("a1.h5: holds no replay"));
    EXPECT_THAT(files(), ElementsAre("a1.h5"));
}

}  // namespace
}  // namespace trocar
