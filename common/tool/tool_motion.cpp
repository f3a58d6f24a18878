#include "common/tool/tool_motion.h"

namespace trocar {

ToolMotion::ToolMotion(const Pose& before, const Pose& after)
    : before_(before), after_(after), translation_(after.position - before.position), turn_(Mat3::Zero()) {
    if (before.rotation != after.rotation) {
        turn_ = Mat3::Identity() - before.rotation * after.rotation.transpose();
    }
}

std::optional<Vec3> ToolMotion::direction_at(const Vec3& point, double negligible) const {
    const Vec3 displacement = displacement_at(point);
    const double length = displacement.norm();
    if (length < negligible || length == 0) return std::nullopt;
    return displacement / length;
}

}  // namespace trocar
