#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "results/xdmf.h"
#include "tests/results/sample.h"

namespace trocar {
namespace {

class PythonTest : public StoreTest {
  protected:
    /// Exit status of read_store.py: 0 when the file reads as it should, 77 when a package is missing.
    [[nodiscard]] int run(const std::string& what) const {
        const auto command =
            fmt::format("/usr/bin/python3 {}/read_store.py {} '{}' '{}'", TROCAR_TEST_FOLDER, what,
                        path("all & more.h5").string(), path("all & replay.xdmf").string());
        // A command of the test's own: NOLINTNEXTLINE(bugprone-command-processor,cert-env33-c)
        return WEXITSTATUS(std::system(command.c_str()));
    }

    /// Cases a2 and a1, in this order, the latter with a replay and two states, the former with one.
    void write_campaign() const {
        CaseRecord record = sample_case("a1");
        record.replay = sample_replay(3);
        record.states = {sample_state(1, "tool-facet", 0.5), sample_state(1, "µ", 0.25)};
        write_case(path("a1.h5"), sample_header(), record);
        const auto a2 = written("a2", {sample_state(2, "tool-facet", std::nan(""))});
        const std::vector<Part> parts{{path("a1.h5"), {}}, {a2, {}}};
        const std::vector<std::string> order{"a2", "a1"};
        merge(path("all & more.h5"), sample_header(), parts, order);
    }
};

TEST_F(PythonTest, H5pyPandasAndXarrayReadACampaign) {
    write_campaign();
    const int status = run("tables");
    if (status == 77) GTEST_SKIP() << "/usr/bin/python3 lacks one of h5py, pandas, xarray, h5netcdf";
    EXPECT_EQ(status, 0);
}

TEST_F(PythonTest, XdmfIsWellFormedAndItsDatasetsExist) {
    write_campaign();
    write_xdmf(path("all & more.h5"), path("all & replay.xdmf"));
    const int status = run("xdmf");
    if (status == 77) GTEST_SKIP() << "/usr/bin/python3 lacks h5py";
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace trocar
