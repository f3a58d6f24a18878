#include "common/tool/pose.h"

#include <Eigen/Geometry>

namespace trocar {

Pose between(const Pose& from, const Pose& to, double part) {
    const Eigen::Quaterniond one(from.rotation), other(to.rotation);
    return {.rotation = one.slerp(part, other).toRotationMatrix(),
            .position = from.position + part * (to.position - from.position)};
}

Vec3 judged_position(const Pose& tool, const Vec3& world) {
    return tool.rotation.transpose() * (world - tool.position);
}

}  // namespace trocar
