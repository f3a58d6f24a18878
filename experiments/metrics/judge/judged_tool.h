#pragma once

#include <array>
#include <vector>

#include "common/geometry/predicates.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool.h"
#include "experiments/metrics/tool_inside/tool_rays.h"
#include "experiments/metrics/tool_inside/winding_integral.h"

namespace trocar {

/// A tool as the metrics see it: its mesh, under CGAL's tree and exact predicates, in its own frame. It
/// shares no code with the solids that strategies and detection ask. Prepared once, safe to share between
/// threads.
class JudgedTool {
  public:
    /// The tool must outlive it.
    explicit JudgedTool(const Tool& tool);

    [[nodiscard]] const Tool& tool() const { return tool_; }
    [[nodiscard]] const SurfaceMesh& mesh() const { return tool_.mesh; }
    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] const SurfaceQueries& surface() const { return surface_; }

    /// Strictly inside; exact.
    [[nodiscard]] bool contains(const Vec3& in_tool) const {
        return box_.contains(in_tool) && surface_.contains(in_tool);
    }

    /// Whether a facet with these corners crosses the tool's surface; exact, touching is not crossing.
    [[nodiscard]] bool crossed_by(const Corners& facet) const;

    [[nodiscard]] const WindingIntegral& winding_integral() const { return winding_integral_; }
    [[nodiscard]] const ToolRays& rays() const { return rays_; }
    /// Of its surface; see tool_points.
    [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

  private:
    const Tool& tool_;
    SurfaceQueries surface_;
    Box box_;
    std::vector<std::array<bool, 3>> flat_edges_;
    WindingIntegral winding_integral_;
    ToolRays rays_;
    std::vector<Vec3> points_;
};

}  // namespace trocar
