#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

// A tool whose material moved by less than this (mm) at a vertex counts as still there.
constexpr double still = 1e-9;
// Closer than this to the line of the normal, the motion has no sideways direction.
constexpr double least_angle = std::numbers::pi / 180;

/// How far, and which way, the tool's material that is now at `point` moved in the step, mm.
Vec3 motion_at(const Vec3& point, const Pose& from, const Pose& to) {
    const Vec3 in_tool = to.rotation.transpose() * (point - to.position);
    return point - from.to_world(in_tool);
}

/// τ: the unit vector along the part of the motion that is at right angles to the normal. None where the tool
/// is still or moves along the normal.
std::optional<Vec3> sideways(const Vec3& motion, const Vec3& normal) {
    const double length = motion.norm();
    if (length < still) return {};
    const Vec3 direction = motion / length;
    const Vec3 tangential = direction - direction.dot(normal) * normal;
    if (tangential.norm() < std::sin(least_angle)) return {};
    return tangential.normalized();
}

}  // namespace

Metric drag() {
    return {.name = "drag",
            .units = "mm",
            .definition =
                "mean over collided vertices of how far handling moves them along with the tool, at "
                "right angles to their normal at rest",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment) -> Measured {
                const JudgedState& before = step.at(Moment::before);
                if (step.collided().empty()) return Missing::no_vertex_collided;
                double sum = 0, vertices = 0;
                for (const Index vertex : step.collided()) {
                    const Vec3 motion =
                        motion_at(before.positions()[vertex], step.tool_at_beginning, before.pose());
                    const auto along = sideways(motion, step.organ().vertex_normals()[vertex]);
                    if (!along) continue;
                    sum += std::max(0.0, step.displacement(vertex).dot(*along));
                    ++vertices;
                }
                return vertices == 0 ? Measured(Missing::motion_along_normal) : sum / vertices;
            }};
}

}  // namespace trocar::metrics
