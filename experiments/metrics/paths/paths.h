#pragma once

#include <map>
#include <set>
#include <vector>

#include "experiments/metrics/judge/judged_state.h"
#include "experiments/metrics/paths/passage.h"

namespace trocar {

/// How far the chords that stand for a vertex's arc may be from it, mm.
inline constexpr double arc_error = 1e-3;

/// Follows every vertex's path relative to the tool from step to step: through which side it went in, and
/// whether it went right through. Between two looks a vertex goes straight where the organ moves and, seen
/// from the tool, along the arc that the tool's motion, a screw (see Arc), makes of a still point. The arc is
/// followed along chords that are within arc_error of it. Copies are independent.
///
/// A vertex that is inside from the beginning came in nowhere: through whichever side it is put out, it does
/// not cross the tool.
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
    /// through the tool in between, in deformation or in the tool's motion; ascending.
    [[nodiscard]] const std::vector<Index>& tunnelled() const { return tunnelled_; }

    /// How many vertices `handled` puts out of the tool on the side opposite to that through which they last
    /// came in (n_entry · n_exit < −0.7071, of outer normals in the tool's frame), also if they came in by
    /// `handled` itself. Nothing is followed on: any answer to the step may be asked about.
    [[nodiscard]] std::size_t crossings(const JudgedState& handled) const;

  private:
    [[nodiscard]] Passage passage_of(Index vertex) const;
    void keep(Index vertex, const Passage& passage);
    void go_straight(const JudgedState& there);

    std::vector<Vec3> in_tool_;       // every vertex where it was last seen, mm
    Pose pose_;                       // of the tool, then
    std::map<Index, Vec3> entries_;   // of vertices inside whose entry is known: the outer normal there
    std::vector<Index> left_inside_;  // by the last handling, ascending
    std::set<Index> went_in_;         // since the last handling
    std::vector<Index> tunnelled_;
};

}  // namespace trocar
