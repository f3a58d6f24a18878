#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/geometry/organ.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool.h"
#include "experiments/metrics/metric.h"

namespace trocar {

/// The organ at one moment of a step, as the judge sees it.
struct JudgedMoment {
    std::vector<Vec3> positions;  ///< of every vertex, mm
    std::vector<Index> inside;    ///< vertices strictly inside the tool, ascending
    std::vector<double> depths;   ///< distance of each of them to the tool's surface, mm
    Index facets_crossing = 0;    ///< facets that cross the tool's surface
};

/// Looks at organs and one tool with CGAL's trees and exact predicates, at the coordinates of
/// judged_position.
class ToolJudge {
  public:
    ToolJudge(const Organ& organ, const Tool& tool);

    [[nodiscard]] JudgedMoment look(std::span<const Vec3> positions, const Pose& pose) const;

  private:
    [[nodiscard]] bool crosses(const Corners& organ_facet) const;

    const Organ& organ_;
    const SurfaceMesh& tool_mesh_;
    SurfaceQueries tool_;
    Box tool_box_;
    std::vector<Corners> tool_facets_;
    std::vector<Box> tool_facet_boxes_;
    std::vector<std::array<bool, 3>> flat_edges_;
};

/// What the metrics of one step are taken from.
class Judged {
  public:
    explicit Judged(const Organ& the_organ) : organ(the_organ) {}

    [[nodiscard]] const JudgedMoment& at(Moment moment) const {
        return moments[static_cast<std::size_t>(moment)];
    }

    const Organ& organ;
    std::array<JudgedMoment, 3> moments;  ///< by Moment
    std::int64_t fallbacks = 0;           ///< as the strategy counted them
};

}  // namespace trocar
