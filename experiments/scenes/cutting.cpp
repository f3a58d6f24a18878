#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "experiments/scenes/draws.h"
#include "experiments/scenes/placement.h"
#include "experiments/scenes/scene_list.h"
#include "experiments/scenes/straight_in.h"

namespace trocar::scenes {
namespace {

constexpr double depth = 15;               // mm below the mouth
constexpr double largest_offset = 0.2;     // of the tool's radius, across the mouth
constexpr double largest_tilt = 5;         // degrees
constexpr double part_of_the_mouth = 0.5;  // its middle, along which entry points are drawn

/// On the mouth of the cleft, the axis along the way out of it but for a tilt.
Placement at_mouth(const SceneInputs& inputs) {
    const Organ& organ = inputs.organ;
    if (!organ.mouth) {
        throw PlacementError(fmt::format("organ \"{}\" has no cleft to cut into; use cleft", organ.name));
    }
    const Mouth& mouth = *organ.mouth;
    const auto where = draw(inputs.seed, 1), free = draw(inputs.seed, 0);
    const Vec3 across = mouth.along.cross(mouth.normal);
    const double along = (where[0] - 0.5) * part_of_the_mouth * mouth.length;
    const double offset = (2 * where[1] - 1) * largest_offset * inputs.tool.radius;
    const double tilt = where[2] * largest_tilt * std::numbers::pi / 180;
    const double towards = 2 * std::numbers::pi * where[3];
    const Vec3 tilt_axis = std::cos(towards) * mouth.along + std::sin(towards) * across;
    const Mat3 tilted = Eigen::AngleAxisd(tilt, tilt_axis).toRotationMatrix();
    return {.entry = mouth.point + along * mouth.along + offset * across,
            .normal = tilted * mouth.normal,
            .tangent = tilted * across,
            .phase = free[1]};
}

}  // namespace

SceneEntry cutting() {
    return {.name = "cutting",
            .summary = "into the mouth of a cleft narrower than the tool, 15 mm, hold, straight out, rest",
            .place = at_mouth,
            .plan = [](const SceneInputs& inputs, const Placement& at) {
                return straight_in(inputs, at, at.normal, depth);
            }};
}

}  // namespace trocar::scenes
