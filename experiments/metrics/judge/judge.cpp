#include "experiments/metrics/judge/judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar {
namespace {

std::vector<Reading> readings_at(std::span<const Metric* const> metrics, bool (*wanted)(Moment)) {
    std::vector<Reading> readings;
    for (const Metric* metric : metrics) {
        for (const Moment moment : metric->moments) {
            if (wanted(moment)) readings.push_back({metric, moment});
        }
    }
    return readings;
}

}  // namespace

int sampled_every(double rate) {
    constexpr double rounding = 1e-9;
    return std::max(1, static_cast<int>(std::ceil(rate / highest_judged_rate - rounding)));
}

std::vector<Reading> readings_of(std::span<const Metric* const> metrics) {
    return readings_at(metrics, [](Moment moment) { return moment != Moment::end; });
}

std::vector<Reading> end_readings(std::span<const Metric* const> metrics) {
    return readings_at(metrics, [](Moment moment) { return moment == Moment::end; });
}

std::vector<Reading> handled_readings(std::span<const Metric* const> metrics) {
    return readings_at(metrics,
                       [](Moment moment) { return moment == Moment::before || moment == Moment::handled; });
}

bool need_shifts(std::span<const Metric* const> metrics) {
    return std::ranges::any_of(metrics, &Metric::of_shifts);
}

std::vector<Measured> values_of(std::span<const Reading> readings, const Judged& step) {
    std::vector<Measured> values;
    values.reserve(readings.size());
    for (const auto& [metric, moment] : readings) values.push_back(metric->value(step, moment));
    return values;
}

Judge::Judge(const JudgedState& start, JudgeSettings settings)
    : settings_(std::move(settings)), step_(start.organ(), start.tool(), settings_.region) {
    step_.before = step_.handled = step_.deformed = start;
    if (std::ranges::any_of(settings_.metrics, &Metric::of_paths)) step_.paths.emplace(start);
}

JudgedState Judge::look(std::span<const Vec3> positions) const {
    return {step_.organ(), step_.tool(), positions, step_.at(Moment::before).pose()};
}

void Judge::before(std::span<const Vec3> positions, const Pose& tool) {
    if (steps_ > 0) step_.step_before = step_.at(Moment::before).positions();
    step_.tool_at_beginning = step_.at(Moment::before).pose();
    if (step_.paths) {
        step_.paths->handle(step_.at(Moment::handled));
        step_.paths->deform(step_.at(Moment::deformed));
    }
    step_.before.emplace(step_.organ(), step_.tool(), positions, tool);
    if (step_.paths) step_.paths->move(step_.at(Moment::before));
    step_.handled.reset();
    step_.deformed.reset();
    ++steps_;
}

void Judge::handled(std::span<const Vec3> positions, std::int64_t fallbacks, const AskShifted& ask) {
    step_.handled = look(positions);
    step_.fallbacks = fallbacks;
    step_.shifted = ask && sampled() && need_shifts(settings_.metrics) ? ask() : ShiftedAnswers{};
}

void Judge::deformed(std::span<const Vec3> positions) { step_.deformed = look(positions); }

std::vector<Measured> Judge::values() const {
    const std::vector<Reading> readings = readings_of(settings_.metrics);
    if (sampled()) return values_of(readings, step_);
    return std::vector<Measured>(readings.size(), Missing::not_sampled);
}

std::vector<Measured> Judge::values_at_end() const {
    return values_of(end_readings(settings_.metrics), step_);
}

}  // namespace trocar
