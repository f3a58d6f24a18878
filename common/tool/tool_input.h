#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/geometry/mesh_check.h"
#include "common/geometry/mesh_error.h"
#include "common/tool/tool.h"

namespace trocar {

/// How a mesh becomes a tool. Directions and points are in the coordinates of the file.
struct ToolPlacement {
    Vec3 axis;  ///< direction from the tip to the handle, of any length
    /// What becomes the tool's origin. None: the height of the lowest vertex along the axis, on the line
    /// through the centroid of the volume.
    std::optional<Vec3> tip = std::nullopt;
    /// Longest side of the box around the mesh, mm. None: as it is.
    std::optional<double> size = std::nullopt;
};

/// A tool from a mesh file.
struct ToolInput {
    Tool tool;                      ///< named like an organ from a file, as in "jaw s80"
    std::vector<Finding> findings;  ///< what was mended and what is worth knowing
};

/// Reads and checks a closed mesh and places it as a tool: `axis` becomes +z by the smallest turn, the tip
/// the origin. Throws MeshError for a file that cannot be used (see read_checked_mesh), an open mesh, one
/// that meets itself, and an axis without length.
ToolInput read_tool(const std::filesystem::path& file, const ToolPlacement& placement);

}  // namespace trocar
