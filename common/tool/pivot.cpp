#include "common/tool/pivot.h"

#include <Eigen/Geometry>

namespace trocar {

Pose pivoted(const Pose& incision, const PivotState& state) {
    using Turn = Eigen::AngleAxisd;
    Pose pose;
    pose.rotation = incision.rotation * (Turn(state.yaw, Vec3::UnitY()) * Turn(state.pitch, Vec3::UnitX()) *
                                         Turn(state.roll, Vec3::UnitZ()))
                                            .toRotationMatrix();
    pose.position = incision.position - state.insertion * pose.rotation.col(2);
    return pose;
}

}  // namespace trocar
