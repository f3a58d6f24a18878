#include "common/tool/tool.h"

#include <algorithm>
#include <utility>

namespace trocar {

Tool make_tool(std::string name, SurfaceMesh mesh) {
    Solid solid(mesh);
    double radius = 0;
    for (const Vec3& position : mesh.positions) radius = std::max(radius, position.head<2>().norm());
    return {.name = std::move(name), .mesh = std::move(mesh), .solid = std::move(solid), .radius = radius};
}

}  // namespace trocar
