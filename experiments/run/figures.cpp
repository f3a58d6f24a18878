#include "experiments/run/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

namespace trocar {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::vector<double> values_in_window(const Series& series, const std::vector<bool>& window) {
    std::vector<double> values;
    for (std::size_t step = 0; step < std::min(series.values.size(), window.size()); ++step) {
        if (window[step] && !std::isnan(series.values[step])) values.push_back(series.values[step]);
    }
    return values;
}

Cell figure(const Series& series, std::string_view suffix, std::string_view meaning, double value) {
    return {.name = fmt::format("{}_{}", series.name, suffix),
            .units = series.units,
            .long_name = fmt::format("{}: {}", series.long_name, meaning),
            .value = value};
}

/// The smallest value that at least this share of the sorted values does not exceed.
double nearest_rank(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return no_value;
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::max<std::size_t>(rank, 1) - 1];
}

struct Budget {
    std::string_view name;
    double nanoseconds;
};
constexpr std::array budgets{Budget{"33ms", 1e9 / 30}, Budget{"25ms", 1e9 / 40}, Budget{"1ms", 1e6}};

Cell steps_over(const Budget& budget, const Series& series, const std::vector<double>& values) {
    const auto over = std::ranges::count_if(values, [&](double value) { return value > budget.nanoseconds; });
    return {.name = fmt::format("{}_over_{}", series.name, budget.name),
            .units = "1",
            .long_name =
                fmt::format("steps of the window that took longer than {:.4g} ms", budget.nanoseconds / 1e6),
            .value = values.empty() ? no_value : static_cast<double>(over)};
}

}  // namespace

std::vector<Cell> metric_figures(std::span<const Series> series, const std::vector<bool>& window) {
    std::vector<Cell> cells;
    for (const Series& one : series) {
        const std::vector<double> values = values_in_window(one, window);
        const bool any = !values.empty();
        const double sum = std::accumulate(values.begin(), values.end(), 0.0);
        const double mean = any ? sum / static_cast<double>(values.size()) : no_value;
        cells.push_back(figure(one, "mean", "mean over the window", mean));
        cells.push_back(
            figure(one, "max", "maximum over the window", any ? std::ranges::max(values) : no_value));
        cells.push_back(figure(one, "final", "last value in the window", any ? values.back() : no_value));
    }
    return cells;
}

std::vector<Cell> time_figures(std::span<const Series> series, const std::vector<bool>& window) {
    std::vector<Cell> cells;
    for (const Series& one : series) {
        std::vector<double> values = values_in_window(one, window);
        std::ranges::sort(values);
        cells.push_back(figure(one, "p50", "median over the window", nearest_rank(values, 0.50)));
        cells.push_back(figure(one, "p95", "95 % quantile over the window", nearest_rank(values, 0.95)));
        cells.push_back(figure(one, "p99", "99 % quantile over the window", nearest_rank(values, 0.99)));
        cells.push_back(figure(one, "max", "maximum over the window", nearest_rank(values, 1.0)));
        if (one.name != "time_cycle") continue;
        for (const Budget& budget : budgets) cells.push_back(steps_over(budget, one, values));
    }
    return cells;
}

void clear_figures(std::span<Cell> figures) {
    for (Cell& cell : figures) cell.value = no_value;
}

}  // namespace trocar
