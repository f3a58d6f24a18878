#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/metrics/judge/judged.h"

namespace trocar {

/// How a case is judged.
struct JudgeSettings {
    std::vector<const Metric*> metrics;  ///< in the order of their values
    Region region;                       ///< of the scene
    int every = 1;                       ///< only each so-manieth step is sampled
};

/// The judge looks at most this often in simulated time, Hz.
inline constexpr double highest_judged_rate = 30;

/// Of a case with this many steps a second, each so-manieth step is sampled.
int sampled_every(double rate);

/// A metric at one of its moments: a series.
struct Reading {
    const Metric* metric;
    Moment moment;
};

/// The series of these metrics, metric by metric; Moment::end has none.
std::vector<Reading> readings_of(std::span<const Metric* const> metrics);

/// Those at Moment::end.
std::vector<Reading> end_readings(std::span<const Metric* const> metrics);

/// Takes the metrics of one case, step by step. It is told where organ and tool are, and nothing of the
/// strategy but what it counted itself and how it would have answered otherwise.
class Judge {
  public:
    /// @param start where organ and tool begin. Its organ and tool must outlive the judge.
    Judge(const JudgedState& start, JudgeSettings settings);
    Judge(const Judge&) = delete;
    Judge& operator=(const Judge&) = delete;

    /// @{
    /// To be called in this order in every step: after detection, after handling, after deformation.
    void before(std::span<const Vec3> positions, const Pose& tool);
    /// `ask` is called at once, in sampled steps of which a chosen metric is `of_shifts`, and in no others.
    void handled(std::span<const Vec3> positions, std::int64_t fallbacks, const AskShifted& ask = {});
    void deformed(std::span<const Vec3> positions);
    /// @}

    /// The step's values, one for each of readings_of(metrics); of a step that is not sampled all are
    /// missing.
    [[nodiscard]] std::vector<Measured> values() const;

    /// The values of end_readings(metrics), once the last step is over.
    [[nodiscard]] std::vector<Measured> values_at_end() const;

    /// The step as far as it has come. A copy may be given another handling and judged by handled_values.
    [[nodiscard]] const Judged& step() const { return step_; }
    [[nodiscard]] const JudgeSettings& settings() const { return settings_; }

  private:
    [[nodiscard]] JudgedState look(std::span<const Vec3> positions) const;
    [[nodiscard]] bool sampled() const { return steps_ % settings_.every == 0; }

    JudgeSettings settings_;
    Judged step_;
    int steps_ = 0;
};

/// Those of the readings that are there once a step has been handled: before and at H.
std::vector<Reading> handled_readings(std::span<const Metric* const> metrics);

/// Whether one of the metrics reads Judged::shifted.
bool need_shifts(std::span<const Metric* const> metrics);

/// The step's value of each of these readings.
std::vector<Measured> values_of(std::span<const Reading> readings, const Judged& step);

}  // namespace trocar
