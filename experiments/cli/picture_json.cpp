#include "experiments/cli/picture_json.h"

#include <nlohmann/json.hpp>

namespace trocar {

using nlohmann::json;

json picture_json(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

json picture_json(std::span<const Vec3> points) {
    json list = json::array();
    for (const Vec3& point : points) list.push_back(picture_json(point));
    return list;
}

json picture_json(const Pose& pose) {
    json rows = json::array();
    for (int row = 0; row < 3; ++row) {
        rows.push_back(
            {pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2), pose.position[row]});
    }
    rows.push_back({0, 0, 0, 1});
    return rows;
}

}  // namespace trocar
