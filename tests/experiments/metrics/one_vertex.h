#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "box_organ.h"
#include "judged_steps.h"

namespace trocar {

/// A box as a tool; its tip end is at low.z().
inline Tool box_tool(const Vec3& low, const Vec3& high) {
    return make_tool("box", box_organ(low, high, 1).rest);
}

inline Pose turned_about(const Vec3& pivot, const Vec3& axis, double angle, const Pose& pose = {}) {
    const Mat3 turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    return {.rotation = turn * pose.rotation, .position = turn * (pose.position - pivot) + pivot};
}

inline Pose at(const Vec3& position) { return {.rotation = Mat3::Identity(), .position = position}; }

/// One vertex that goes where a test says, of a facet whose other corners are far away, and a tool.
class OneVertex {
  public:
    explicit OneVertex(Tool tool)
        : steps_(make_organ("facet",
                            {.positions = {{500, 0, 0}, {500, 1, 0}, {500, 0, 1}}, .facets = {{0, 1, 2}}}),
                 std::move(tool)) {}

    [[nodiscard]] const JudgedTool& tool() const { return steps_.judged_tool(); }
    [[nodiscard]] std::vector<Vec3> positions(const Vec3& vertex) const {
        std::vector<Vec3> positions = steps_.rest();
        positions[0] = vertex;
        return positions;
    }
    [[nodiscard]] JudgedState state(const Vec3& vertex, const Pose& pose) const {
        return steps_.state(positions(vertex), pose);
    }

    /// Whether it tunnels when it goes from `handled` to `deformed` while the tool is at `from`, whereupon
    /// the tool goes to `to`.
    [[nodiscard]] bool tunnels(const Vec3& handled, const Vec3& deformed, const Pose& from,
                               const Pose& to) const {
        Paths paths(state(handled, from));
        paths.deform(state(deformed, from));
        paths.move(state(deformed, to));
        return !paths.tunnelled().empty();
    }
    /// The same where only the tool moves.
    [[nodiscard]] bool tunnels(const Vec3& vertex, const Pose& from, const Pose& to) const {
        return tunnels(vertex, vertex, from, to);
    }

    /// How often it crosses when the tool goes from `from` to `to` and then handling moves it to `handled`.
    [[nodiscard]] std::size_t crossings(const Vec3& vertex, const Pose& from, const Pose& to,
                                        const Vec3& handled) const {
        Paths paths(state(vertex, from));
        paths.move(state(vertex, to));
        return paths.crossings(state(handled, to));
    }

  private:
    JudgedSteps steps_;
};

}  // namespace trocar
