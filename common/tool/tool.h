#pragma once

#include <string>

#include "common/geometry/solid.h"
#include "common/tool/pose.h"

namespace trocar {

/// A rigid surgical tool in its own frame: tip at the origin, axis (from tip to handle) along +z.
struct Tool {
    std::string name;  ///< as it is written in results, such as "prism-12"
    SurfaceMesh mesh;
    Solid solid;
    Vec3 axis = Vec3::UnitZ();
    double radius = 0;  ///< largest distance of a vertex from the axis, mm
};

/// Throws std::invalid_argument when the mesh is no closed solid (see Solid).
Tool make_tool(std::string name, SurfaceMesh mesh);

/// A tool at a pose: its solid queries, asked and answered in world coordinates. It refers to the tool and
/// must not outlive it.
class PlacedTool {
  public:
    PlacedTool(const Tool& tool, const Pose& pose) : tool_(&tool), pose_(pose) {}

    [[nodiscard]] const Tool& tool() const { return *tool_; }
    [[nodiscard]] const Pose& pose() const { return pose_; }

    /// Unit vector from tip to handle.
    [[nodiscard]] Vec3 axis() const { return pose_.direction_to_world(tool_->axis); }

    [[nodiscard]] bool convex() const { return tool_->solid.convex(); }

    /// Strictly inside, exact at the point's judged coordinates.
    [[nodiscard]] bool contains(const Vec3& point) const {
        return tool_->solid.contains(judged_position(pose_, point));
    }
    /// See Solid::exit_distance.
    [[nodiscard]] double exit_distance(const Vec3& point, const Vec3& direction, double clearance) const {
        return tool_->solid.exit_distance(judged_position(pose_, point), pose_.direction_to_tool(direction),
                                          clearance);
    }
    /// See Solid::nearest_face; the normal is in world coordinates.
    [[nodiscard]] NearestFace nearest_face(const Vec3& point) const {
        NearestFace nearest = tool_->solid.nearest_face(judged_position(pose_, point));
        nearest.normal = pose_.direction_to_world(nearest.normal);
        return nearest;
    }
    /// See Solid::closest; position and normal are in world coordinates.
    [[nodiscard]] SurfacePoint closest(const Vec3& point) const {
        SurfacePoint found = tool_->solid.closest(judged_position(pose_, point));
        found.position = pose_.to_world(found.position);
        found.normal = pose_.direction_to_world(found.normal);
        return found;
    }
    /// Whether a point is within `distance` (mm) of the tool or inside it.
    [[nodiscard]] bool within(const Vec3& point, double distance) const {
        return tool_->solid.within(judged_position(pose_, point), distance);
    }
    /// The tool's vertex that is furthest along `direction`.
    [[nodiscard]] Vec3 support(const Vec3& direction) const {
        return pose_.to_world(tool_->solid.support(pose_.direction_to_tool(direction)));
    }

  private:
    const Tool* tool_;
    Pose pose_;
};

}  // namespace trocar
