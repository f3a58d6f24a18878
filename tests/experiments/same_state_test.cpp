#include "experiments/run/same_state.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_alone.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

/// The cases of one condition, one of each strategy.
std::vector<CaseInputs> two_cases() {
    const SweepFolder folder;
    const std::string finer = replaced(replaced(small_sweep, "sphere@12mm", "sphere@4mm"), "[400]", "[100]");
    return list_cases(folder.read(replaced(finer, "seeds = 2", "seeds = 1")));
}

CaseOptions comparing(int states) {
    CaseOptions options;
    options.same_state = states;
    for (const CaseInputs& inputs : two_cases()) options.answering.push_back(inputs.strategy);
    return options;
}

CaseRecord run(const CaseInputs& inputs, const CaseOptions& options) {
    const auto strategy = make_strategy(inputs.strategy.name, inputs.strategy.options);
    return run_alone(inputs, *strategy, options).value();
}

const Value& value(const std::vector<Cell>& row, std::string_view column) {
    return std::ranges::find(row, column, &Cell::name)->value;
}

std::size_t step_of(const std::vector<Cell>& row) {
    return static_cast<std::size_t>(std::get<std::int64_t>(value(row, "step")));
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(SameState, EveryStrategyAnswersEveryState) {
    const CaseRecord record = run(two_cases()[0], comparing(2));
    ASSERT_EQ(record.states.size(), 4U);
    std::set<std::size_t> steps;
    for (const auto& row : record.states) {
        steps.insert(step_of(row));
        EXPECT_EQ(std::get<std::string>(value(row, "reason")), "");
        EXPECT_GT(std::get<double>(value(row, "collided_vertices")), 0);
    }
    EXPECT_EQ(steps.size(), 2U);
    EXPECT_EQ(std::get<std::string>(value(record.states[0], "label")), "nearest-face");
    EXPECT_EQ(std::get<std::string>(value(record.states[1], "label")), "fuzzy-per-vertex");
    EXPECT_THAT(std::get<std::string>(value(record.states[1], "options")),
                testing::HasSubstr(R"("aggregate":"sum")"));
    EXPECT_TRUE(std::ranges::is_sorted(record.states, {}, step_of));
}

TEST(SameState, TheRunsOwnAnswerIsWhatTheRunMeasured) {
    const std::vector<CaseInputs> cases = two_cases();
    for (const CaseInputs& inputs : cases) {
        const CaseRecord record = run(inputs, comparing(4));
        for (const auto& row : record.states) {
            if (std::get<std::string>(value(row, "label")) != inputs.strategy.label) continue;
            for (const Series& series : record.series) {
                const auto cell = std::ranges::find(row, series.name, &Cell::name);
                if (cell == row.end()) continue;
                EXPECT_TRUE(same(std::get<double>(cell->value), series.values[step_of(row)])) << series.name;
            }
        }
    }
}

TEST(SameState, AnotherStrategyGetsTheStateThatTheRunFound) {
    // Both runs start alike: in the first step with a collision both find the same state, so each must give
    // in the other's run the answer that it gives in its own.
    const std::vector<CaseInputs> cases = two_cases();
    const CaseRecord one = run(cases[0], comparing(1000)), other = run(cases[1], comparing(1000));
    const std::size_t first = step_of(one.states[0]);
    ASSERT_EQ(first, step_of(other.states[0]));
    for (std::size_t answer = 0; answer < 2; ++answer) {
        for (const Cell& cell : one.states[answer]) {
            const auto* number = std::get_if<double>(&cell.value);
            if (number == nullptr) continue;
            EXPECT_TRUE(same(*number, std::get<double>(value(other.states[answer], cell.name)))) << cell.name;
        }
    }
}

TEST(SameState, AsksEveryStrategyAgainAlsoInStepsThatAreNotSampled) {
    CaseInputs inputs = two_cases()[1];
    inputs.cycle.rate = 60;
    CaseOptions options = comparing(1000);
    options.metrics = choose_metrics("order_spread,order_spread_mean");
    const CaseRecord record = run(inputs, options);
    int fuzzy = 0;
    for (const auto& row : record.states) {
        const double spread = std::get<double>(value(row, "order_spread"));
        const double mean = std::get<double>(value(row, "order_spread_mean"));
        ASSERT_FALSE(std::isnan(spread)) << "step " << step_of(row);
        EXPECT_LE(mean, spread);
        if (std::get<std::string>(value(row, "label")) == "nearest-face") {
            EXPECT_EQ(spread, 0);
        } else if (spread > 0) {
            ++fuzzy;
        }
    }
    EXPECT_GT(fuzzy, 1);
}

TEST(SameState, ChangesNothingInTheRun) {
    const CaseRecord with = run(two_cases()[1], comparing(5)), without = run(two_cases()[1], comparing(0));
    EXPECT_TRUE(without.states.empty());
    for (std::size_t k = 0; k < with.series.size(); ++k) {
        if (with.series[k].name.starts_with("time_")) continue;
        EXPECT_TRUE(std::ranges::equal(with.series[k].values, without.series[k].values, same))
            << with.series[k].name;
    }
}

TEST(SameState, TheSampledStatesDependOnTheCaseAlone) {
    const CaseRecord once = run(two_cases()[0], comparing(3)), again = run(two_cases()[0], comparing(3));
    for (std::size_t row = 0; row < once.states.size(); ++row) {
        EXPECT_EQ(step_of(once.states[row]), step_of(again.states[row]));
    }
}

TEST(SameState, AStrategyWithoutAnAnswerHasAReasonAndNoFigures) {
    CaseOptions options = comparing(2);
    options.answering.push_back({.name = "no-such-strategy", .label = "none", .options = {}});
    const CaseRecord record = run(two_cases()[0], options);
    ASSERT_EQ(record.states.size(), 6U);
    const auto& row = record.states[2];
    EXPECT_NE(std::get<std::string>(value(row, "reason")), "");
    EXPECT_TRUE(std::isnan(std::get<double>(value(row, "displacement_mean"))));
    EXPECT_TRUE(std::isnan(std::get<double>(value(row, "vertices_inside_h"))));
    EXPECT_NE(std::get<std::string>(value(row, "missing")).find("\"drag\":\"no answer\""), std::string::npos);
}

}  // namespace
}  // namespace trocar
