#include "experiments/run/case_series.h"

#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
        case Moment::end:
            return "after the last step";
    }
    throw std::logic_error("a moment without a name");
}

Series time_series(std::string_view phase, std::string_view meaning) {
    return {.name = fmt::format("time_{}", phase),
            .units = "ns",
            .long_name = std::string(meaning),
            .values = {},
            .missing = {}};
}

/// For each reason the ranges of steps, first and last, that it holds for.
nlohmann::json ranges_by_reason(const std::vector<Missing>& missing) {
    nlohmann::json ranges = nlohmann::json::object();
    for (std::size_t step = 0; step < missing.size(); ++step) {
        if (missing[step] == Missing::nothing) continue;
        nlohmann::json& of_reason = ranges[std::string(missing_reason(missing[step]))];
        if (step > 0 && missing[step] == missing[step - 1]) {
            of_reason.back()[1] = step;
        } else {
            of_reason.push_back({step, step});
        }
    }
    return ranges;
}

}  // namespace

std::string reading_long_name(const Reading& reading) {
    return fmt::format("{}, {}", reading.metric->definition, moment_name(reading.moment));
}

CaseSeries empty_series(const std::vector<const Metric*>& metrics) {
    CaseSeries series;
    for (const Reading& reading : readings_of(metrics)) {
        series.metrics.push_back({.name = series_name(*reading.metric, reading.moment),
                                  .units = reading.metric->units,
                                  .long_name = reading_long_name(reading),
                                  .values = {},
                                  .missing = {}});
    }
    series.missing.resize(series.metrics.size());
    series.times = {time_series("move", "wall clock of moving the tool"),
                    time_series("detect", "wall clock of collision detection"),
                    time_series("handle", "wall clock of collision handling"),
                    time_series("deform", "wall clock of deformation"),
                    time_series("cycle", "wall clock of the four phases together")};
    series.window = {.name = "window",
                     .units = "1",
                     .long_name = "1 where the tool at its pose meets the organ at rest, else 0",
                     .values = {},
                     .missing = {}};
    return series;
}

void append_step(CaseSeries& series, const std::vector<Measured>& values, const PhaseTimes& times,
                 bool in_window) {
    for (std::size_t i = 0; i < series.metrics.size(); ++i) {
        series.metrics[i].values.push_back(values.at(i).value);
        series.missing[i].push_back(values[i].missing);
    }
    const std::array phases{times.move, times.detect, times.handle, times.deform, times.cycle()};
    for (std::size_t i = 0; i < phases.size(); ++i) {
        series.times[i].values.push_back(static_cast<double>(phases[i]));
    }
    series.window.values.push_back(in_window ? 1 : 0);
}

void note_missing(CaseSeries& series) {
    for (std::size_t i = 0; i < series.metrics.size(); ++i) {
        const nlohmann::json ranges = ranges_by_reason(series.missing[i]);
        if (!ranges.empty()) series.metrics[i].missing = ranges.dump();
    }
}

std::string missing_in_window(const CaseSeries& series) {
    nlohmann::json counts = nlohmann::json::object();
    for (std::size_t i = 0; i < series.metrics.size(); ++i) {
        for (std::size_t step = 0; step < series.steps(); ++step) {
            const Missing missing = series.missing[i][step];
            if (missing == Missing::nothing || missing == Missing::not_sampled) continue;
            if (series.window.values[step] == 0) continue;
            nlohmann::json& count = counts[series.metrics[i].name][std::string(missing_reason(missing))];
            count = count.is_null() ? 1 : count.get<int>() + 1;
        }
    }
    return counts.empty() ? "" : counts.dump();
}

}  // namespace trocar
