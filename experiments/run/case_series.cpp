#include "experiments/run/case_series.h"

#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace trocar {
namespace {

std::string_view moment_name(Moment moment) {
    switch (moment) {
        case Moment::before:
            return "as the step found the organ";
        case Moment::handled:
            return "after handling";
        case Moment::deformed:
            return "after deformation";
    }
    throw std::logic_error("a moment without a name");
}

Series time_series(std::string_view phase, std::string_view meaning) {
    return {.name = fmt::format("time_{}", phase),
            .units = "ns",
            .long_name = std::string(meaning),
            .values = {}};
}

}  // namespace

CaseSeries empty_series() {
    CaseSeries series;
    for (const Metric& metric : all_metrics()) {
        for (const Moment moment : metric.moments) {
            series.metrics.push_back(
                {.name = series_name(metric, moment),
                 .units = metric.units,
                 .long_name = fmt::format("{}, {}", metric.definition, moment_name(moment)),
                 .values = {}});
        }
    }
    series.times = {time_series("move", "wall clock of moving the tool"),
                    time_series("detect", "wall clock of collision detection"),
                    time_series("handle", "wall clock of collision handling"),
                    time_series("deform", "wall clock of deformation"),
                    time_series("cycle", "wall clock of the four phases together")};
    series.window = {.name = "window",
                     .units = "1",
                     .long_name = "1 where the tool at its pose meets the organ at rest, else 0",
                     .values = {}};
    return series;
}

void append_step(CaseSeries& series, const std::vector<double>& metric_values, const PhaseTimes& times,
                 bool in_window) {
    for (std::size_t i = 0; i < series.metrics.size(); ++i) {
        series.metrics[i].values.push_back(metric_values.at(i));
    }
    const std::array phases{times.move, times.detect, times.handle, times.deform, times.cycle()};
    for (std::size_t i = 0; i < phases.size(); ++i) {
        series.times[i].values.push_back(static_cast<double>(phases[i]));
    }
    series.window.values.push_back(in_window ? 1 : 0);
}

}  // namespace trocar
