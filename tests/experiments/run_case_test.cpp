#include "experiments/run/run_case.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_alone.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

using testing::HasSubstr;

/// A strategy that does what a test tells it to.
class Scripted : public Strategy {
  public:
    explicit Scripted(Handler handler) : handler_(std::move(handler)) {}
    [[nodiscard]] Promises promises() const override { return {}; }
    void handle(const Contact& contact, Response& response) override { handler_(contact, response); }

  private:
    Handler handler_;
};

CaseInputs small_case() {
    const SweepFolder folder;
    return list_cases(folder.read(small_sweep)).front();
}

/// What is measured: metrics that have no strategy asked again, so that one can count its steps.
CaseOptions once_a_step() {
    CaseOptions options;
    options.metrics = choose_metrics("fast");
    options.replay = true;
    return options;
}

CaseRecord run_scripted(Handler handler) {
    Scripted strategy(std::move(handler));
    return run_alone(small_case(), strategy, once_a_step()).value();
}

const Value& value(const CaseRecord& record, std::string_view column) {
    return std::ranges::find(record.cells, column, &Cell::name)->value;
}

std::string text(const CaseRecord& record, std::string_view column) {
    return std::get<std::string>(value(record, column));
}

std::vector<std::string> columns(const CaseRecord& record) {
    std::vector<std::string> names;
    for (const Cell& cell : record.cells) names.push_back(cell.name);
    return names;
}

TEST(RunCase, FillsColumnsSeriesAndReplay) {
    const CaseInputs inputs = small_case();
    const CaseRecord record = run_alone(inputs, true);
    EXPECT_EQ(record.case_id, inputs.case_id);
    EXPECT_EQ(text(record, "status"), "complete") << text(record, "reason");
    EXPECT_EQ(text(record, "label"), "nearest-face");
    EXPECT_EQ(std::get<double>(value(record, "speed")), 400);
    EXPECT_GT(std::get<double>(value(record, "collided_vertices_max")), 0);
    ASSERT_FALSE(record.time.empty());
    EXPECT_DOUBLE_EQ(record.time.front(), 1.0 / 30);
    for (const Series& series : record.series)
        EXPECT_EQ(series.values.size(), record.time.size()) << series.name;
    ASSERT_TRUE(record.replay);
    ASSERT_EQ(record.replay->steps.size(), record.time.size());
    const ReplayStep& step = record.replay->steps.back();
    EXPECT_EQ(record.replay->tool_start, step.tool_pose) << "penetration goes back to where it started";
    EXPECT_EQ(step.found.size(), inputs.organ.organ->rest.positions.size());
    EXPECT_EQ(step.handled.size(), step.found.size());
    EXPECT_EQ(step.deformed.size(), step.found.size());
}

TEST(RunCase, FiguresFollowFromTheSeriesOverTheWindow) {
    const CaseRecord record = run_alone(small_case(), false);
    EXPECT_FALSE(record.replay);
    const Series& window = record.series.back();
    ASSERT_EQ(window.name, "window");
    const auto collided = std::ranges::find(record.series, "collided_vertices", &Series::name);
    double sum = 0, steps = 0;
    for (std::size_t i = 0; i < window.values.size(); ++i) {
        sum += window.values[i] * collided->values[i];
        steps += window.values[i];
    }
    EXPECT_LT(steps, window.values.size());
    EXPECT_EQ(std::get<double>(value(record, "collided_vertices_mean")), sum / steps);
}

std::vector<double> values(const CaseRecord& record, std::string_view name) {
    return std::ranges::find(record.series, name, &Series::name)->values;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// One in which vertices collide in several steps.
CaseInputs finer_case() {
    const SweepFolder folder;
    return list_cases(folder.read(replaced(small_sweep, "sphere@12mm", "sphere@4mm"))).front();
}

CaseRecord run_asking(const CaseInputs& inputs, const CaseOptions& options) {
    const auto strategy = make_strategy(inputs.strategy.name, inputs.strategy.options);
    return run_alone(inputs, *strategy, options).value();
}

CaseOptions asking_for(std::string_view metrics) {
    CaseOptions options;
    options.metrics = choose_metrics(metrics);
    return options;
}

TEST(RunCase, TellsHowItWasJudged) {
    const CaseRecord record = run_asking(small_case(), asking_for("drag,recovery"));
    EXPECT_EQ(text(record, "metrics"), "drag,recovery");
    EXPECT_EQ(std::get<double>(value(record, "judged_rate")), 30);
    const std::vector<double> window = values(record, "window");
    EXPECT_EQ(std::get<std::int64_t>(value(record, "window_steps")), std::ranges::count(window, 1));
    EXPECT_GT(std::get<double>(value(record, "recovery_final")), 0);
    for (const std::string& name : columns(record)) EXPECT_FALSE(name.starts_with("depth")) << name;
}

TEST(RunCase, TellsWhyValuesAreMissing) {
    const CaseRecord record = run_asking(finer_case(), asking_for("collided_vertices,displacement_mean"));
    const std::vector<double> window = values(record, "window"),
                              collided = values(record, "collided_vertices");
    const std::vector<double> displacement = values(record, "displacement_mean");
    int missing = 0;
    for (std::size_t step = 0; step < window.size(); ++step) {
        EXPECT_EQ(std::isnan(displacement[step]), collided[step] == 0) << "step " << step;
        if (window[step] == 1 && collided[step] == 0) ++missing;
    }
    ASSERT_GT(missing, 0);
    const auto first = std::ranges::find(collided, 0) - collided.begin();
    EXPECT_EQ(text(record, "missing"),
              fmt::format(R"({{"displacement_mean":{{"no vertex collided":{}}}}})", missing));
    const auto series = std::ranges::find(record.series, "displacement_mean", &Series::name);
    EXPECT_THAT(series->missing, testing::StartsWith(fmt::format(R"({{"no vertex collided":[[{},)", first)));
    EXPECT_EQ(std::ranges::find(record.series, "collided_vertices", &Series::name)->missing, "");
}

TEST(RunCase, IsJudgedAtMostThirtyTimesASecond) {
    CaseInputs inputs = finer_case();
    inputs.cycle.rate = 75;
    const CaseRecord record = run_asking(inputs, asking_for("collided_vertices,tunnelled"));
    EXPECT_EQ(std::get<double>(value(record, "judged_rate")), 25);
    const std::vector<double> collided = values(record, "collided_vertices");
    for (std::size_t step = 0; step < collided.size(); ++step) {
        EXPECT_EQ(std::isnan(collided[step]), (step + 1) % 3 != 0) << "step " << step;
    }
    EXPECT_EQ(text(record, "missing"), "") << "a step that is not sampled misses nothing";
    EXPECT_GT(std::get<double>(value(record, "collided_vertices_max")), 0);
}

TEST(RunCase, AsksTheStrategyAgainOnlyForMetricsThatNeedIt) {
    const auto calls_with = [](std::string_view metrics) {
        int calls = 0;
        Scripted strategy([&](const Contact&, Response&) { ++calls; });
        const CaseRecord record = run_alone(small_case(), strategy, asking_for(metrics)).value();
        return calls - static_cast<int>(record.time.size());
    };
    EXPECT_EQ(calls_with("fast"), 0);
    EXPECT_GT(calls_with("order_spread_mean"), 0);
}

TEST(RunCase, AsksTheStrategyAgainOfWhatItWasGiven) {
    const CaseInputs inputs = finer_case();
    std::vector<Vec3> found, velocities;
    int again = 0;
    Scripted strategy([&](const Contact& contact, Response& response) {
        if (&contact.organ == inputs.organ.organ.get()) {
            found.assign(contact.positions.begin(), contact.positions.end());
            velocities.assign(contact.velocities.begin(), contact.velocities.end());
        } else {
            ++again;
            EXPECT_TRUE(std::ranges::equal(contact.positions, found));
            EXPECT_TRUE(std::ranges::equal(contact.velocities, velocities));
        }
        for (const Index vertex : contact.collided)
            response.displacements.push_back({vertex, Vec3(0, 0, -1)});
    });
    const CaseRecord record = run_alone(inputs, strategy, asking_for("order_spread")).value();
    EXPECT_EQ(std::get<double>(value(record, "order_spread_max")), 0);
    EXPECT_GT(again, 1);
}

TEST(RunCase, IsTheSameToTheBitWhetherTheStrategyIsAskedAgainOrNot) {
    CaseInputs inputs = finer_case();
    inputs.strategy = {.name = "fuzzy-per-vertex", .label = "fuzzy", .options = {}};
    const std::string others = "collided_vertices,depth_max,displacement_mean,strain,jitter,fallbacks";
    CaseOptions with = asking_for(others + ",order_spread,order_spread_mean"), without = asking_for(others);
    with.replay = without.replay = true;
    const CaseRecord asked = run_asking(inputs, with), alone = run_asking(inputs, without);
    EXPECT_GT(std::get<double>(value(asked, "order_spread_max")), 0);
    for (const Series& series : alone.series) {
        if (series.name.starts_with("time_")) continue;
        EXPECT_TRUE(std::ranges::equal(values(asked, series.name), series.values, [](double a, double b) {
            return same_bits(a, b);
        })) << series.name;
    }
    ASSERT_EQ(asked.replay->steps.size(), alone.replay->steps.size());
    for (std::size_t step = 0; step < alone.replay->steps.size(); ++step) {
        EXPECT_EQ(asked.replay->steps[step].deformed, alone.replay->steps[step].deformed) << "step " << step;
    }
}

void expect_no_figures(const CaseRecord& record) {
    EXPECT_EQ(columns(record), columns(run_asking(small_case(), once_a_step())));
    EXPECT_TRUE(std::isnan(std::get<double>(value(record, "collided_vertices_max"))));
    EXPECT_TRUE(std::isnan(std::get<double>(value(record, "time_cycle_over_1ms"))));
}

TEST(RunCase, AStrategyThatThrowsFailsItsCaseOnly) {
    int calls = 0;
    const CaseRecord record = run_scripted([&](const Contact&, Response&) {
        if (++calls == 3) throw std::runtime_error("no idea");
    });
    EXPECT_EQ(text(record, "status"), "failed");
    EXPECT_EQ(text(record, "reason"), "step 2: no idea");
    EXPECT_EQ(record.time.size(), 2U) << "the steps before are kept";
    EXPECT_EQ(record.replay->steps.size(), 2U);
    expect_no_figures(record);
}

TEST(RunCase, AnAnswerThatIsNotFiniteFails) {
    const CaseRecord record = run_scripted([](const Contact&, Response& response) {
        response.displacements.push_back({0, Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)});
    });
    EXPECT_EQ(text(record, "status"), "failed");
    EXPECT_THAT(text(record, "reason"), HasSubstr("step 0"));
    expect_no_figures(record);
}

TEST(RunCase, AnOrganThatFliesApartIsDiverged) {
    const CaseRecord record = run_scripted([](const Contact&, Response& response) {
        response.displacements.push_back({5, Vec3(0, 0, 1e5)});
    });
    EXPECT_EQ(text(record, "status"), "diverged");
    EXPECT_THAT(text(record, "reason"), HasSubstr("vertex 5 is 1e+05 mm from its rest place"));
    EXPECT_TRUE(record.time.empty());
    expect_no_figures(record);
}

TEST(RunCase, ASeedWithoutAPlaceFailsWithItsReason) {
    const SweepFolder folder;
    const std::string thick =
        replaced(small_sweep, "\"prism-6\"", "{ shape = \"prism\", sides = 6, radius = 70, length = 200 }");
    const CaseInputs on_sheet = list_cases(folder.read(replaced(thick, "sphere@12mm", "sheet@12mm"))).front();
    const CaseRecord record = run_asking(on_sheet, once_a_step());
    EXPECT_EQ(text(record, "status"), "failed") << "no point of the sheet is two radii from its boundary";
    EXPECT_NE(text(record, "reason"), "");
    expect_no_figures(record);
}

TEST(RunCase, StopsBetweenStepsWhenAsked) {
    std::stop_source stop;
    int calls = 0;
    Scripted strategy([&](const Contact&, Response&) {
        if (++calls == 2) stop.request_stop();
    });
    EXPECT_FALSE(run_alone(small_case(), strategy, once_a_step(), stop.get_token()));
    EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace trocar
