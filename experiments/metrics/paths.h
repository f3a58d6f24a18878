#pragma once

#include <map>
#include <vector>

#include "experiments/metrics/judged_state.h"

namespace trocar {

/// Follows every vertex's path relative to the tool from step to step: through which side it went in, and
/// whether it went right through. Between two looks a vertex goes straight where the organ moves and, seen
/// from the tool, along the arc that the tool's motion makes of a still point. Copies are independent.
class Paths {
  public:
    /// @param start where organ and tool begin
    explicit Paths(const JudgedState& start);

    /// The tool has gone to where `before` has it.
    void move(const JudgedState& before);
    /// Handling has moved vertices.
    void handle(const JudgedState& handled);
    /// Deformation has moved vertices.
    void deform(const JudgedState& deformed);

    /// Vertices that were outside after the last handling and are outside after the last move, and went
    /// through the tool in between, in deformation or in the tool's motion.
    [[nodiscard]] const std::vector<Index>& tunnelled() const { return tunnelled_; }

    /// How many vertices `handled` puts out of the tool on the side opposite to that through which they came
    /// in (n_entry · n_exit < −0.7071). Nothing is followed on: any answer to the step may be asked about.
    [[nodiscard]] std::size_t crossings(const JudgedState& handled) const;

  private:
    std::vector<Vec3> positions_;    // of every vertex, mm
    Pose pose_;                      // of the tool
    std::map<Index, Vec3> entries_;  // of vertices inside whose entry is known: the outer normal there
    std::vector<Index> tunnelled_;
};

}  // namespace trocar
