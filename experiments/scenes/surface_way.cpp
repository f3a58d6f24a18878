#include "experiments/scenes/surface_way.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "experiments/scenes/mean_normal.h"

namespace trocar {
namespace {

constexpr double step = 1;                             // mm, in the tangent plane
constexpr double least_advance = 0.5;                  // mm, of a step along the surface
constexpr double largest_turn = std::numbers::pi / 6;  // rad a step
constexpr double negligible = 1e-9;                    // mm

/// A step ahead in the tangent plane, put back on the surface; none where that faces no way.
std::optional<Pose> step_ahead(const SceneInputs& inputs, const Pose& from) {
    const SurfacePoint on =
        inputs.organ_queries.closest(from.position + step * from.rotation.col(0), negligible);
    const auto normal = mean_normal(inputs.organ, on.position, on.facet, 2 * inputs.tool.radius);
    if (!normal) return std::nullopt;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(from.rotation.col(2), *normal);
    return Pose{.rotation = turn.toRotationMatrix() * from.rotation, .position = on.position};
}

bool follows(const Pose& from, const Pose& to) {
    return (to.position - from.position).norm() >= least_advance &&
           from.rotation.col(2).dot(to.rotation.col(2)) >= std::cos(largest_turn);
}

}  // namespace

std::optional<std::vector<Pose>> surface_way(const SceneInputs& inputs, const Pose& start, double length) {
    std::vector<Pose> way;
    Pose at = start;
    for (double left = length; left > negligible;) {
        const std::optional<Pose> next = step_ahead(inputs, at);
        if (!next || !follows(at, *next)) return std::nullopt;
        const double advance = (next->position - at.position).norm();
        at = advance > left ? between(at, *next, left / advance) : *next;
        left -= advance;
        way.push_back(at);
    }
    return way;
}

}  // namespace trocar
