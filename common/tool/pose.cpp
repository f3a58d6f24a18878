#include "common/tool/pose.h"

namespace trocar {

Vec3 judged_position(const Pose& tool, const Vec3& world) {
    return tool.rotation.transpose() * (world - tool.position);
}

}  // namespace trocar
