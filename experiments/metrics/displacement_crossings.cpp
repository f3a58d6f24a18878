#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

constexpr double near_part = 0.1;  // of the edge's length: closer than this is crossing
constexpr double least_angle = 5 * std::numbers::pi / 180;  // flatter than this is side by side
// How far, as a part of a segment, a point is from its ends to be an inner point, so that rounding makes no
// crossing of two segments that share an end.
constexpr double inner = 1e-9;

bool is_inner(double part) { return part > inner && part < 1 - inner; }

/// Whether the segments that the ends of an edge go along come within `reach` (mm) of each other at an inner
/// point of both, at a steep enough angle.
bool segments_cross(const Vec3& a, const Vec3& d_a, const Vec3& b, const Vec3& d_b, double reach) {
    const double aa = d_a.squaredNorm(), bb = d_b.squaredNorm(), ab = d_a.dot(d_b);
    // |d_a × d_b|² = aa bb sin²(angle); where one of them is still, both sides are zero.
    const double cross = d_a.cross(d_b).squaredNorm();
    if (cross == 0 || cross < aa * bb * std::sin(least_angle) * std::sin(least_angle)) return false;
    // The lines' closest points; where both are inner points they are the segments'.
    const Vec3 from_b = a - b;
    const double part_a = (ab * d_b.dot(from_b) - bb * d_a.dot(from_b)) / cross;
    const double part_b = (aa * d_b.dot(from_b) - ab * d_a.dot(from_b)) / cross;
    if (!is_inner(part_a) || !is_inner(part_b)) return false;
    return (from_b + part_a * d_a - part_b * d_b).norm() <= reach;
}

}  // namespace

Metric displacement_crossings() {
    return {.name = "displacement_crossings",
            .units = "1",
            .definition =
                "edges with two collided ends whose displacement segments cross (within 10 % of the "
                "edge's length, at 5 degrees or more), or that handling turned around",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment moment) -> Measured {
                const auto &before = step.at(Moment::before).positions(),
                           &after = step.at(moment).positions();
                double crossings = 0;
                for (const auto& [a, b] : step.organ().edges()) {
                    if (!step.collided(a) || !step.collided(b)) continue;
                    const Vec3 edge = before[b] - before[a];
                    const bool turned = edge.dot(after[b] - after[a]) < 0;
                    if (turned || segments_cross(before[a], step.displacement(a), before[b],
                                                 step.displacement(b), near_part * edge.norm())) {
                        ++crossings;
                    }
                }
                return crossings;
            }};
}

}  // namespace trocar::metrics
