#include "experiments/run/figures.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace trocar {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double figure(const std::vector<Cell>& cells, std::string_view name) {
    for (const Cell& cell : cells) {
        if (cell.name == name) return std::get<double>(cell.value);
    }
    ADD_FAILURE() << "no column " << name;
    return nan;
}

std::vector<Cell> metric_figures_of(std::vector<double> values, const std::vector<bool>& window) {
    const std::vector<Series> series{{.name = "depth_max_d",
                                      .units = "mm",
                                      .long_name = "depth",
                                      .values = std::move(values),
                                      .missing = {}}};
    return metric_figures(series, window);
}

TEST(MetricFigures, CountOnlyStepsInTheWindow) {
    const auto cells = metric_figures_of({100, 1, 4, 1, 100}, {false, true, true, true, false});
    EXPECT_EQ(cells.size(), 3U);
    EXPECT_EQ(figure(cells, "depth_max_d_mean"), 2);
    EXPECT_EQ(figure(cells, "depth_max_d_max"), 4);
    EXPECT_EQ(figure(cells, "depth_max_d_final"), 1);
    EXPECT_EQ(cells[0].units, "mm");
}

TEST(MetricFigures, StepsWithoutAValueDoNotCount) {
    const auto cells = metric_figures_of({nan, -2, -6, nan}, {true, true, true, true});
    EXPECT_EQ(figure(cells, "depth_max_d_mean"), -4);
    EXPECT_EQ(figure(cells, "depth_max_d_max"), -2);
    EXPECT_EQ(figure(cells, "depth_max_d_final"), -6);
}

TEST(MetricFigures, WithoutAnyValueThereIsNone) {
    for (const auto& cells : {metric_figures_of({nan, 3}, {true, false}), metric_figures_of({}, {true, true}),
                              metric_figures_of({1, 2}, {})}) {
        EXPECT_TRUE(std::isnan(figure(cells, "depth_max_d_mean")));
        EXPECT_TRUE(std::isnan(figure(cells, "depth_max_d_max")));
        EXPECT_TRUE(std::isnan(figure(cells, "depth_max_d_final")));
    }
}

std::vector<Cell> time_figures_of(std::string name, std::vector<double> values) {
    const std::vector<bool> window(values.size(), true);
    const std::vector<Series> series{{.name = std::move(name),
                                      .units = "ns",
                                      .long_name = "time",
                                      .values = std::move(values),
                                      .missing = {}}};
    return time_figures(series, window);
}

TEST(TimeFigures, AreNearestRankQuantiles) {
    std::vector<double> hundred;  // 100, 99, …, 1
    for (int i = 100; i > 0; --i) hundred.push_back(i);
    const auto cells = time_figures_of("time_handle", hundred);
    EXPECT_EQ(cells.size(), 4U) << "budgets are the whole cycle's";
    EXPECT_EQ(figure(cells, "time_handle_p50"), 50);
    EXPECT_EQ(figure(cells, "time_handle_p95"), 95);
    EXPECT_EQ(figure(cells, "time_handle_p99"), 99);
    EXPECT_EQ(figure(cells, "time_handle_max"), 100);
}

TEST(TimeFigures, OfFewStepsAreValuesThatOccurred) {
    EXPECT_EQ(figure(time_figures_of("time_handle", {10, 20, 30}), "time_handle_p50"), 20);
    EXPECT_EQ(figure(time_figures_of("time_handle", {10, 20, 30}), "time_handle_p95"), 30);
    const auto cells = time_figures_of("time_handle", {7});
    EXPECT_EQ(figure(cells, "time_handle_p50"), 7);
    EXPECT_EQ(figure(cells, "time_handle_p99"), 7);
}

TEST(TimeFigures, CountStepsOverEachBudget) {
    const auto cells = time_figures_of("time_cycle", {1e6, 1.1e6, 24e6, 26e6, 33.3e6, 33.4e6});
    EXPECT_EQ(figure(cells, "time_cycle_over_1ms"), 5);
    EXPECT_EQ(figure(cells, "time_cycle_over_25ms"), 3);
    EXPECT_EQ(figure(cells, "time_cycle_over_33ms"), 1);
    EXPECT_TRUE(std::isnan(figure(time_figures_of("time_cycle", {}), "time_cycle_over_1ms")));
}

}  // namespace
}  // namespace trocar
