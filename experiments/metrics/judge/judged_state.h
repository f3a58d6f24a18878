#pragma once

#include <optional>
#include <span>
#include <vector>

#include "experiments/metrics/judge/judged_organ.h"
#include "experiments/metrics/judge/judged_tool.h"

namespace trocar {

/// Organ and tool at one moment of a step. What metrics share is worked out when one of them first asks; not
/// to be asked from several threads.
class JudgedState {
  public:
    /// Organ and tool must outlive it; the positions are copied.
    JudgedState(const JudgedOrgan& organ, const JudgedTool& tool, std::span<const Vec3> positions,
                const Pose& pose);

    [[nodiscard]] const JudgedOrgan& organ() const { return *organ_; }
    [[nodiscard]] const JudgedTool& tool() const { return *tool_; }
    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }  ///< of every vertex, mm
    [[nodiscard]] const Pose& pose() const { return pose_; }                         ///< of the tool

    /// Every vertex in the tool's frame, at its judged_position: what exact questions are asked of.
    [[nodiscard]] const std::vector<Vec3>& in_tool() const&;
    /// The vertices strictly inside the tool, ascending.
    [[nodiscard]] const std::vector<Index>& inside() const&;
    /// The distance of each of them to the tool's surface, mm.
    [[nodiscard]] const std::vector<double>& depths() const&;
    [[nodiscard]] bool is_inside(Index vertex) const;
    /// The organ's facets that cross the tool's surface, ascending.
    [[nodiscard]] const std::vector<Index>& crossing_facets() const&;

    /// @{
    /// What is worked out dies with the state.
    void in_tool() const&& = delete;
    void inside() const&& = delete;
    void depths() const&& = delete;
    void crossing_facets() const&& = delete;
    /// @}

  private:
    const JudgedOrgan* organ_;
    const JudgedTool* tool_;
    std::vector<Vec3> positions_;
    Pose pose_;
    mutable std::optional<std::vector<Vec3>> in_tool_;
    mutable std::optional<std::vector<Index>> inside_;
    mutable std::vector<bool> is_inside_;  // by vertex, once inside_ is there
    mutable std::optional<std::vector<double>> depths_;
    mutable std::optional<std::vector<Index>> crossing_facets_;
};

}  // namespace trocar
