// Strategies that end their process, or never end: each is contained, and the others go on.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "experiments/run/run_sweep.h"
#include "experiments/sweep/hash.h"
#include "results/store.h"
#include "sweep_folder.h"
#include "tests/address_sanitizer.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::UnorderedElementsAre;
using testing_support::address_sanitizer;

/// Handles as nearest-face does, but misbehaves in the first step that has contact.
class Misbehaving : public Strategy {
  public:
    explicit Misbehaving(std::function<void(const Contact&, Response&)> misbehave)
        : good_(make_strategy("nearest-face")), misbehave_(std::move(misbehave)) {}
    [[nodiscard]] Promises promises() const override { return {}; }
    void handle(const Contact& contact, Response& response) override {
        if (!contact.collided.empty() && !std::exchange(has_, true)) misbehave_(contact, response);
        good_->handle(contact, response);
    }

  private:
    std::unique_ptr<Strategy> good_;
    std::function<void(const Contact&, Response&)> misbehave_;
    bool has_ = false;
};

/// Two strategies on two seeds; "nearest-face" misbehaves on both.
class Contained : public testing::Test {
  protected:
    [[nodiscard]] RunRequest request(const std::function<void(const Contact&, Response&)>& misbehave) const {
        const Sweep sweep = folder_.read(R"(
            name = "contained"
            strategies = ["nearest-face", "cylinder-axis"]
            organs = ["sphere@5mm"]
            tools = ["prism-6"]
            scenes = ["penetration"]
            speeds = [100]
            seeds = 2
        )");
        RunRequest request;
        request.out = folder_.path("out.h5");
        request.header = {.created_utc = "2009-11-05T12:00:00Z",
                          .generator = "test",
                          .sweep_toml = sweep.text,
                          .sweep_hash = hash_of(sweep.text)};
        request.cases = list_cases(sweep);
        for (const CaseInputs& inputs : request.cases) request.case_order.push_back(inputs.case_id);
        request.options.metrics = choose_metrics("depth_max");
        request.build_id = "build 1";
        request.jobs = 2;
        request.options.make = [misbehave](const StrategyChoice& choice) -> std::unique_ptr<Strategy> {
            if (choice.name == "nearest-face") return std::make_unique<Misbehaving>(misbehave);
            return make_strategy(choice.name, choice.options);
        };
        return request;
    }

    RunOutcome run(const RunRequest& request) {
        return run_sweep(request, [](std::size_t, std::size_t) {}, {});
    }

    /// Two cases end so, the other two are complete; the failures say who and why.
    void expect_contained(const RunRequest& request, const std::string& status, const std::string& reason) {
        const RunOutcome outcome = run(request);
        EXPECT_THAT(outcome.by_status, UnorderedElementsAre(Pair("complete", 2), Pair(status, 2)));
        ASSERT_EQ(outcome.failures.size(), 2U);
        for (const std::string& line : outcome.failures) {
            EXPECT_THAT(line, HasSubstr(status + ": nearest-face"));
            EXPECT_THAT(line, HasSubstr(reason));
        }
        EXPECT_EQ(read_contents(request.out).cases.size(), 4U);
    }

    SweepFolder folder_;
};

TEST_F(Contained, AStrategyThatSegfaults) {
    const auto segfault = [](const Contact&, Response&) { std::raise(SIGSEGV); };
    // AddressSanitizer turns the signal into an exit of its own.
    expect_contained(request(segfault), "crashed", address_sanitizer ? "exit code" : "signal 11");
}

TEST_F(Contained, AStrategyThatAborts) {
    expect_contained(request([](const Contact&, Response&) { std::abort(); }), "crashed", "signal 6");
}

TEST_F(Contained, AStrategyThatExits) {
    expect_contained(request([](const Contact&, Response&) { _exit(0); }), "crashed", "exit code 0");
}

TEST_F(Contained, AStrategyThatLoopsForever) {
    RunRequest looping = request([](const Contact&, Response&) {
        while (true) usleep(1000);
    });
    looping.limits.seconds = 1.5;
    expect_contained(looping, "timed_out", "longer than 1.5 s");
}

TEST_F(Contained, AStrategyThatAllocatesWithoutEnd) {
    RunRequest allocating = request([](const Contact&, Response&) {
        std::vector<std::vector<char>> all;
        while (true) {
            all.emplace_back(10'000'000, 'x');
            usleep(2000);
        }
    });
    allocating.limits.bytes = 300'000'000;
    expect_contained(allocating, "out_of_memory", "0.3 GB");
}

TEST_F(Contained, AStrategyThatReturnsNaN) {
    expect_contained(request([](const Contact& contact, Response& response) {
                         const double nan = std::numeric_limits<double>::quiet_NaN();
                         response.forces.push_back({contact.collided.front(), Vec3(nan, 0, 0)});
                     }),
                     "failed", "step");
}

TEST_F(Contained, AStrategyThatThrows) {
    expect_contained(request([](const Contact&, Response&) { throw std::runtime_error("no idea"); }),
                     "failed", "no idea");
}

TEST_F(Contained, AStrategyThatWritesPastItsSpan) {
    if (!address_sanitizer) GTEST_SKIP() << "needs AddressSanitizer: make sanitize";
    expect_contained(request([](const Contact& contact, Response&) {
                         auto* beyond =
                             const_cast<Vec3*>(contact.positions.data()) + contact.positions.size();
                         beyond->x() = 1;
                     }),
                     "crashed", "exit code");
}

/// Handles as nearest-face does, and misbehaves when it is gone.
class GoingWithABang : public Misbehaving {
  public:
    GoingWithABang() : Misbehaving([](const Contact&, Response&) {}) {}
    GoingWithABang(const GoingWithABang&) = delete;
    GoingWithABang& operator=(const GoingWithABang&) = delete;
    ~GoingWithABang() override { std::abort(); }
};

TEST_F(Contained, AStrategyThatAbortsWhenItIsGone) {
    RunRequest going = request({});
    going.jobs = 1;
    going.options.make = [](const StrategyChoice& choice) -> std::unique_ptr<Strategy> {
        if (choice.name == "nearest-face") return std::make_unique<GoingWithABang>();
        return make_strategy(choice.name, choice.options);
    };
    expect_contained(going, "crashed", "signal 6");
}

TEST_F(Contained, AStrategyThatCannotBeMade) {
    RunRequest unmade = request({});
    unmade.options.make = [](const StrategyChoice& choice) -> std::unique_ptr<Strategy> {
        if (choice.name == "nearest-face") throw std::runtime_error("no licence");
        return make_strategy(choice.name, choice.options);
    };
    expect_contained(unmade, "failed", "the strategy cannot be made: no licence");
}

TEST_F(Contained, WhatACaseLeavesBehindDoesNotCountAgainstTheNext) {
    RunRequest leaking = request([](const Contact&, Response&) {
        static std::vector<std::vector<char>> kept;
        kept.emplace_back(200'000'000, 'x');
    });
    leaking.jobs = 1;
    leaking.limits.bytes = 300'000'000;
    EXPECT_THAT(run(leaking).by_status, ElementsAre(Pair("complete", 4)));
}

/// Of each row of /states who answered, and why not: as Python reads it.
std::string answers_in(const std::filesystem::path& file) {
    const std::string script =
        "import h5py, sys; s = h5py.File(sys.argv[1])['states']; "
        "print(*sorted(zip(s['label'].asstr()[:], s['reason'].asstr()[:])), sep='\\n')";
    const std::string command = "/usr/bin/python3 -c \"" + script + "\" '" + file.string() + "'";
    // A command of the test's own: NOLINTNEXTLINE(bugprone-command-processor,cert-env33-c)
    const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), &pclose);
    std::string text;
    for (int letter = 0; (letter = std::fgetc(output.get())) != EOF;) text += static_cast<char>(letter);
    return text;
}

TEST_F(Contained, AStrategyThatAbortsWhenItIsAskedAboutAnothersStates) {
    RunRequest asked = request([](const Contact&, Response&) { std::abort(); });
    asked.options.same_state = 2;
    asked.options.answering = {asked.cases[0].strategy, asked.cases[2].strategy};
    expect_contained(asked, "crashed", "signal 6");
    // Its own runs ended before they had states to hand out; the other strategy's have two each.
    const std::string ended =
        "('nearest-face', 'it ended the process when it was asked, or took more than a case may take')\n";
    const std::string answered = "('cylinder-axis', '')\n";
    EXPECT_EQ(answers_in(asked.out),
              answered + answered + answered + answered + ended + ended + ended + ended);
}

TEST_F(Contained, ACaseThatIsKilledFromOutsideIsTriedAgain) {
    const std::filesystem::path mark = folder_.path("killed once");
    const RunRequest killed = request([mark](const Contact&, Response&) {
        if (!std::filesystem::create_directory(mark)) return;
        std::raise(SIGKILL);
    });
    EXPECT_THAT(run(killed).by_status, ElementsAre(Pair("complete", 4)));
}

TEST_F(Contained, ACaseThatIsKilledAgainAndAgainIsGivenUp) {
    expect_contained(request([](const Contact&, Response&) { std::raise(SIGKILL); }), "crashed", "signal 9");
}

TEST_F(Contained, WhatWasContainedIsTheSameOnceItBehaves) {
    run(request([](const Contact&, Response&) { std::abort(); }));
    // The same build: what failed stays, what is missing is run.
    const RunOutcome again = run(request([](const Contact&, Response&) {}));
    EXPECT_EQ(again.ran, 0U);
    EXPECT_THAT(again.by_status, UnorderedElementsAre(Pair("complete", 2), Pair("crashed", 2)));
}

TEST_F(Contained, TimingRunsOneCaseAtATimeAndSpreadsStrategies) {
    RunRequest timing = request([](const Contact&, Response&) {});
    timing.timing = true;
    EXPECT_THAT(run(timing).by_status, ElementsAre(Pair("complete", 4)));
}

}  // namespace
}  // namespace trocar
