#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "experiments/metrics/judge/judged_state.h"
#include "experiments/metrics/judge/region.h"
#include "experiments/metrics/judge/shifted_answers.h"
#include "experiments/metrics/metric.h"
#include "experiments/metrics/paths/paths.h"

namespace trocar {

/// What the metrics of one step are taken from.
class Judged {
  public:
    Judged(const JudgedOrgan& organ, const JudgedTool& tool, const Region& the_region)
        : region(the_region), organ_(organ), tool_(tool) {}

    [[nodiscard]] const JudgedOrgan& organ() const { return organ_; }
    [[nodiscard]] const JudgedTool& tool() const { return tool_; }

    /// Organ and tool at a moment. Throws std::logic_error where it has not come yet.
    [[nodiscard]] const JudgedState& at(Moment moment) const {
        const auto& state = moment == Moment::before    ? before
                            : moment == Moment::handled ? handled
                                                        : deformed;
        if (!state) throw std::logic_error("this moment of the step is not there to be judged");
        return *state;
    }
    /// The vertices strictly inside the tool before handling, ascending.
    [[nodiscard]] const std::vector<Index>& collided() const { return at(Moment::before).inside(); }
    [[nodiscard]] bool collided(Index vertex) const { return at(Moment::before).is_inside(vertex); }
    /// How handling moved a vertex, mm.
    [[nodiscard]] Vec3 displacement(Index vertex) const {
        return at(Moment::handled).positions()[vertex] - at(Moment::before).positions()[vertex];
    }

    const Region& region;    ///< of the scene
    Pose tool_at_beginning;  ///< of the step; at all its moments the tool is where it went
    std::optional<JudgedState> before, handled, deformed;
    std::vector<Vec3> step_before;  ///< every vertex as the step before found it, mm; empty in the first step
    std::optional<Paths> paths;     ///< as far as `before`; where a chosen metric asks for them
    std::int64_t fallbacks = 0;     ///< as the strategy counted them
    ShiftedAnswers shifted;         ///< where a chosen metric asks for them

  private:
    const JudgedOrgan& organ_;
    const JudgedTool& tool_;
};

}  // namespace trocar
