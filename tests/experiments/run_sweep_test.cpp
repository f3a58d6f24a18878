#include "experiments/run/run_sweep.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/input_error.h"
#include "experiments/run/done_cases.h"
#include "experiments/run/parts_folder.h"
#include "experiments/run/run_case.h"
#include "experiments/sweep/hash.h"
#include "results/store.h"
#include "run_alone.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

const auto silent = [](std::size_t, std::size_t) {};

class RunSweep : public testing::Test {
  protected:
    [[nodiscard]] RunRequest request(const std::string& text = small_sweep) const {
        const Sweep sweep = folder_.read(text);
        RunRequest request;
        request.out = out_;
        request.header = {.created_utc = "2009-11-05T12:00:00Z",
                          .generator = "test",
                          .sweep_toml = sweep.text,
                          .sweep_hash = hash_of(sweep.text)};
        request.cases = list_cases(sweep);
        for (const CaseInputs& inputs : request.cases) request.case_order.push_back(inputs.case_id);
        request.build_id = "build 1";
        return request;
    }

    [[nodiscard]] std::vector<std::string> stored_ids() const {
        std::vector<std::string> ids;
        for (const auto& one : read_contents(out_).cases) ids.push_back(one.case_id);
        return ids;
    }

    SweepFolder folder_;
    std::filesystem::path out_ = folder_.path("out.h5");
};

TEST_F(RunSweep, StoresEveryCaseInTheSweepsOrderAndLeavesNoParts) {
    RunRequest four = request();
    four.jobs = 3;
    const RunOutcome outcome = run_sweep(four, silent, {});
    EXPECT_EQ(outcome.ran, 4U);
    EXPECT_FALSE(outcome.interrupted);
    EXPECT_THAT(outcome.by_status, ElementsAre(Pair("complete", 4)));
    EXPECT_EQ(stored_ids(), four.case_order);
    EXPECT_FALSE(std::filesystem::exists(parts_folder_of(out_)));
}

TEST_F(RunSweep, ASecondRunRunsNothingAndLeavesTheFileAsItIs) {
    run_sweep(request(), silent, {});
    const std::string before = read_bytes(out_);
    const RunOutcome outcome = run_sweep(request(), silent, {});
    EXPECT_EQ(outcome.ran, 0U);
    EXPECT_EQ(outcome.kept, 4U);
    EXPECT_THAT(outcome.by_status, ElementsAre(Pair("complete", 4)));
    EXPECT_EQ(read_bytes(out_), before);
}

TEST_F(RunSweep, AnotherBuildRunsEverythingAgain) {
    run_sweep(request(), silent, {});
    RunRequest rebuilt = request();
    rebuilt.build_id = "build 2";
    EXPECT_EQ(run_sweep(rebuilt, silent, {}).ran, 4U);
    EXPECT_EQ(read_contents(out_).cases.front().build_id, "build 2");
}

TEST_F(RunSweep, WithoutReplaysThereIsNothingForParaView) {
    EXPECT_EQ(run_sweep(request(), silent, {}).xdmf, "");
}

TEST_F(RunSweep, CasesWithoutReplayRunAgainWhenReplaysAreAskedFor) {
    run_sweep(request(), silent, {});
    RunRequest with_replay = request();
    with_replay.options.replay = true;
    with_replay.cases.resize(1);
    const RunOutcome outcome = run_sweep(with_replay, silent, {});
    EXPECT_EQ(outcome.ran, 1U);
    EXPECT_TRUE(std::filesystem::exists(outcome.xdmf)) << "ParaView's way to the replay";
    const Contents contents = read_contents(out_);
    EXPECT_TRUE(contents.cases[0].has_replay);
    EXPECT_FALSE(contents.cases[1].has_replay);
    EXPECT_EQ(contents.cases.size(), 4U) << "cases that are not asked for stay";
}

RunRequest taking(RunRequest request, std::string_view metrics) {
    request.options.metrics = choose_metrics(metrics);
    return request;
}

TEST_F(RunSweep, CasesRunAgainForMetricsThatWereNotTaken) {
    run_sweep(taking(request(), "all"), silent, {});
    EXPECT_EQ(run_sweep(taking(request(), "fast"), silent, {}).ran, 0U) << "all of them were taken";

    std::filesystem::remove(out_);
    run_sweep(taking(request(), "drag"), silent, {});
    EXPECT_EQ(read_contents(out_).cases[0].metrics, "drag");
    EXPECT_EQ(run_sweep(taking(request(), "drag"), silent, {}).ran, 0U);
    EXPECT_EQ(run_sweep(taking(request(), "depth_max"), silent, {}).ran, 4U);
    EXPECT_EQ(read_contents(out_).cases[0].metrics, "depth_max,drag") << "what was measured stays";
}

TEST_F(RunSweep, CasesThatRunAgainForMetricsKeepTheirReplay) {
    RunRequest with_replay = taking(request(), "drag");
    with_replay.options.replay = true;
    run_sweep(with_replay, silent, {});
    EXPECT_EQ(run_sweep(taking(request(), "strain"), silent, {}).ran, 4U);
    EXPECT_TRUE(read_contents(out_).cases[0].has_replay);
}

TEST_F(RunSweep, AnInterruptedRunKeepsWholeCasesAndGoesOn) {
    std::stop_source stop;
    const RunOutcome cut = run_sweep(
        request(), [&](std::size_t, std::size_t) { stop.request_stop(); }, stop.get_token());
    EXPECT_TRUE(cut.interrupted);
    EXPECT_EQ(cut.ran, 1U);
    EXPECT_THAT(stored_ids(), ElementsAre(request().case_order[0]));
    const RunOutcome rest = run_sweep(request(), silent, {});
    EXPECT_EQ(rest.kept, 1U);
    EXPECT_EQ(rest.ran, 3U);
    EXPECT_EQ(stored_ids(), request().case_order);
}

/// A fresh run whose folder of parts is there again after it, as when it is killed before it can remove it.
class KilledFreshRun : public RunSweep {
  protected:
    KilledFreshRun() {
        RunRequest earlier = request();
        earlier.build_id = "build 0";
        run_sweep(earlier, silent, {});
        before_ = read_bytes(out_);
        fresh_.fresh = true;
        const auto keep_when_all_are_there = [&](std::size_t done, std::size_t total) {
            if (done == total) std::filesystem::copy(parts_, kept_);
        };
        run_sweep(fresh_, keep_when_all_are_there, {});
        std::filesystem::rename(kept_, parts_);
    }

    RunRequest fresh_ = request();
    std::string before_;  ///< the bytes of the result file
    std::filesystem::path parts_ = fresh_parts_folder_of(out_);
    std::filesystem::path kept_ = folder_.path("kept");
};

TEST_F(KilledFreshRun, AfterItsResultWasPublishedIsOver) {
    EXPECT_EQ(pending_cases(fresh_).size(), 4U);
    std::stop_source stop;
    const RunOutcome cut = run_sweep(
        fresh_, [&](std::size_t, std::size_t) { stop.request_stop(); }, stop.get_token());
    EXPECT_EQ(cut.kept, 0U);
    EXPECT_FALSE(cut.merged);
    EXPECT_EQ(run_sweep(fresh_, silent, {}).by_status.at("complete"), 4U);
    EXPECT_FALSE(std::filesystem::exists(parts_));
}

TEST_F(KilledFreshRun, BeforeItsResultWasPublishedGoesOn) {
    std::ofstream(out_, std::ios::binary) << before_;
    EXPECT_THAT(pending_cases(fresh_), testing::IsEmpty());
    const RunOutcome outcome = run_sweep(fresh_, silent, {});
    EXPECT_EQ(outcome.kept, 4U);
    EXPECT_EQ(outcome.ran, 0U);
    EXPECT_EQ(read_contents(out_).cases.front().build_id, "build 1");
    EXPECT_FALSE(std::filesystem::exists(parts_));
}

TEST_F(RunSweep, ARunStoppedBeforeItsFirstCaseWritesNothing) {
    std::stop_source stop;
    stop.request_stop();
    const RunOutcome outcome = run_sweep(request(), silent, stop.get_token());
    EXPECT_TRUE(outcome.interrupted);
    EXPECT_FALSE(std::filesystem::exists(out_));
    EXPECT_FALSE(std::filesystem::exists(parts_folder_of(out_)));
}

TEST_F(RunSweep, PartsThatAKilledRunLeftAreUsed) {
    const RunRequest four = request();
    CaseRecord record = run_alone(four.cases[2], false);
    record.build_id = four.build_id;
    std::filesystem::create_directory(parts_folder_of(out_));
    write_case(parts_folder_of(out_) / (record.case_id + ".h5"), four.header, record);
    const RunOutcome outcome = run_sweep(four, silent, {});
    EXPECT_EQ(outcome.kept, 1U);
    EXPECT_EQ(outcome.ran, 3U);
    EXPECT_EQ(stored_ids(), four.case_order);
}

void expect_refused(const RunRequest& request, const std::string& message) {
    const auto never = [](std::size_t, std::size_t) { FAIL() << "a case ran"; };
    try {
        run_sweep(request, never, {});
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(message));
        EXPECT_THAT(error.what(), HasSubstr(request.out.string()));
    }
    EXPECT_FALSE(std::filesystem::exists(parts_folder_of(request.out)));
}

TEST_F(RunSweep, ResultsOfAnotherSweepAreNotWrittenOver) {
    run_sweep(request(), silent, {});
    const std::string before = read_bytes(out_);
    expect_refused(request(replaced(small_sweep, "seeds = 2", "seeds = 1")), "another sweep");
    EXPECT_EQ(read_bytes(out_), before);
}

TEST_F(RunSweep, AFileThatIsNoResultIsNotWrittenOver) {
    std::ofstream(out_) << "my notes";
    expect_refused(request(), "choose another output");
    EXPECT_EQ(read_bytes(out_), "my notes");
}

TEST_F(RunSweep, AnOutputThatCannotBeWrittenIsRefusedBeforeAnythingRuns) {
    RunRequest nowhere = request();
    nowhere.out = folder_.path("no/such/folder/out.h5");
    expect_refused(nowhere, "cannot be written");
    RunRequest folder = request();
    folder.out = folder_.path("folder.h5");
    std::filesystem::create_directory(folder.out);
    expect_refused(folder, "is no file");
}

TEST_F(RunSweep, TwoRunsOfOneOutputDoNotMix) {
    const PartsFolder other_run(out_, PartsOf::any_run);
    EXPECT_THROW(run_sweep(request(), silent, {}), InputError);
}

}  // namespace
}  // namespace trocar
