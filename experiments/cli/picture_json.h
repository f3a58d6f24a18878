#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include "common/geometry/vector.h"
#include "common/tool/pose.h"

namespace trocar {

/// @{
/// As the analysis reads what it draws: a point as [x, y, z], a pose as the rows of the 4 by 4 matrix that
/// takes the tool's coordinates to the world's.
nlohmann::json picture_json(const Vec3& point);
nlohmann::json picture_json(std::span<const Vec3> points);
nlohmann::json picture_json(const Pose& pose);
/// @}

}  // namespace trocar
