#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include "results/pending_file.h"
#include "results/supervised.h"
#include "results/xdmf.h"
#include "tests/address_sanitizer.h"
#include "tests/results/sample.h"

namespace trocar {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::address_sanitizer;

class DamagedTest : public StoreTest {
  protected:
    /// What a child that does `action` is answered with.
    template <class Action>
    [[nodiscard]] std::string error_after(Action action) const {
        const std::vector<std::filesystem::path> files{path("a1.h5")};
        return error_of([&] {
            supervised(files, [&] {
                now_reading(path("b2.h5"));
                action();
                return std::string();
            });
        });
    }

    void write_bytes(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }
};

TEST_F(DamagedTest, WhatTheChildReturnsComesBack) {
    std::string long_text(3'000'000, 'x');
    EXPECT_EQ(supervised({}, [&] { return long_text; }), long_text);
}

TEST_F(DamagedTest, WhatTheChildThrowsComesBack) {
    EXPECT_EQ(error_after([] { throw StoreError("b2.h5: is unwell"); }), "b2.h5: is unwell");
    EXPECT_THAT(error_after([] { throw std::length_error("too long"); }),
                HasSubstr("b2.h5: is damaged: too long"));
}

TEST_F(DamagedTest, ACrashIsReportedWithTheFileThatWasRead) {
    EXPECT_THAT(error_after([] { std::raise(SIGKILL); }),
                AllOf(HasSubstr("b2.h5: is damaged: reading it ended with signal 9"), HasSubstr("Killed")));
    EXPECT_THAT(error_after([] { _exit(7); }),
                HasSubstr("b2.h5: is damaged: reading it ended with exit code 7"));
}

TEST_F(DamagedTest, MemoryWithoutEndIsRefused) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer reserves terabytes, so that there is no limit";
#endif
    EXPECT_THAT(error_after([] { std::vector<char>(std::size_t{1} << 30U, 'x').front() = 'y'; }),
                HasSubstr("b2.h5: is damaged: it asks for more memory than its size explains"));
}

TEST_F(DamagedTest, AReaderThatDoesNotEndIsEnded) {
    const auto forever = [] {
        const volatile bool going_on = true;
        while (going_on) {
        }
    };
    EXPECT_THAT(error_after(forever),
                HasSubstr("b2.h5: is damaged: reading it takes longer than its size explains"));
}

TEST_F(DamagedTest, ListsOfTextsKeepEveryByte) {
    const std::vector<std::string> texts{"", "12:x", std::string("a\0b", 3), "µ"};
    EXPECT_EQ(split_texts(joined_texts(texts)), texts);
    EXPECT_EQ(split_texts(""), std::vector<std::string>());
    for (const auto* broken : {"x", "5:abc", "3abc", "99999999999999999999:a"})
        EXPECT_THAT(error_of([&] { static_cast<void>(split_texts(broken)); }), HasSubstr("cut off"))
            << broken;
}

TEST_F(DamagedTest, RowsThatNoStoredBytesExplainAreRefused) {
    const auto file = written("a1");
    {
        const hdf5::Session session;
        const hdf5::File open(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
        const hdf5::Group cases = hdf5::open_group(open.id(), "cases");
        hdf5::create_dataset(cases.id(), {"odd", "1", "odd"}, H5T_IEEE_F64LE, {9'000'000});
    }
    const std::vector<Part> parts{{.file = file, .case_ids = {}}};
    EXPECT_THAT(
        error_of([&] { merge(path("all.h5"), sample_header(), parts, std::vector<std::string>{"a1"}); }),
        HasSubstr("a1.h5: /cases/odd: claims 9000000 rows, but only 0 bytes are stored"));
}

/// Byte flips, runs of one byte, and truncations; the same for the same seed.
std::string mutated(std::string bytes, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t limit) { return random() % limit; };
    switch (seed % 4) {
        case 0:
            return bytes.substr(0, below(bytes.size()));
        case 1: {
            const std::size_t start = below(bytes.size());
            const std::size_t count = std::min<std::size_t>(1 + below(64), bytes.size() - start);
            return bytes.replace(start, count, count, static_cast<char>(below(2) * 255));
        }
        default:
            for (std::size_t flips = 1 + below(20); flips > 0; --flips)
                bytes[below(bytes.size())] = static_cast<char>(below(256));
            return bytes;
    }
}

TEST_F(DamagedTest, NoMutationOfAFileEndsTheReader) {
    CaseRecord record = sample_case("a1");
    record.replay = sample_replay(3);
    record.states = {sample_state(1, "s", 1)};
    write_case(path("a1.h5"), sample_header(), record);
    const std::string whole = bytes_of(path("a1.h5"));
    const std::vector<Part> parts{{path("bad.h5"), {}}};
    int refused = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        write_bytes("bad.h5", mutated(whole, seed));
        std::string error = error_of([&] { read_contents(path("bad.h5")); });
        if (error == "nothing thrown") {
            error = error_of(
                [&] { merge(path("all.h5"), sample_header(), parts, std::vector<std::string>{"a1"}); });
            error_of([&] { write_xdmf(path("bad.h5"), path("all.xdmf")); });
        }
        if (error == "nothing thrown") continue;
        ++refused;
        EXPECT_THAT(error, testing::AnyOf(HasSubstr("bad.h5"), HasSubstr("all.h5"))) << "seed " << seed;
    }
    EXPECT_GT(refused, 50);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    if (!address_sanitizer) {
        EXPECT_LT(children.ru_maxrss, 1'000'000) << "kB";
    }
    for (const auto* name : {"all.h5", "all.xdmf"}) std::filesystem::remove(path(name));
    EXPECT_THAT(files(), ElementsAre("a1.h5", "bad.h5"));
}

TEST_F(DamagedTest, WhatAKilledProcessLeftIsRemoved) {
    std::array<char, 256> host{};
    ASSERT_EQ(gethostname(host.data(), host.size() - 1), 0);
    write_bytes(std::string("all.h5.tmp.") + host.data() + ".123", "half");
    write_bytes("all.h5.tmp.elsewhere.123", "half");
    write_bytes("all.h5", "whole");
    write_bytes(std::string("a1.h5.tmp.") + host.data() + ".9", "half");
    remove_abandoned(path(""), "all.h5");
    EXPECT_EQ(files().size(), 3U) << "all.h5, another machine's, another file's";
    remove_abandoned(path(""), "");
    EXPECT_THAT(files(), ElementsAre("all.h5", "all.h5.tmp.elsewhere.123"));
}

}  // namespace
}  // namespace trocar
