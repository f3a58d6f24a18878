#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/mesh_check.h"
#include "common/geometry/mesh_error.h"
#include "common/geometry/organ.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Reads the triangles of an OFF, OBJ, STL or PLY file, as they stand there. Throws MeshError for a file that
/// cannot be read or has no facets.
SurfaceMesh read_mesh(const std::filesystem::path& file);

/// Scales the mesh about the origin until the longest side of its bounding box is `size` (mm): mesh files
/// have no units. Throws MeshError when `size` is not a positive length or the box is no box.
void scale_to_size(SurfaceMesh& mesh, double size);

/// A mesh file that passed check_mesh.
struct CheckedMesh {
    SurfaceMesh mesh;
    std::vector<Finding> findings;  ///< what was mended and what is worth knowing
};

/// Reads, scales (where a `size` in mm is given) and checks a mesh. Throws MeshError with everything that was
/// found when the mesh cannot be used.
CheckedMesh read_checked_mesh(const std::filesystem::path& file, std::optional<double> size = {});

/// An organ from a file.
struct OrganInput {
    Organ organ;  ///< named like the file without its extension, with the size, as in "spot_23k s100"
    std::vector<Finding> findings;
};

/// See read_checked_mesh.
OrganInput read_organ(const std::filesystem::path& file, std::optional<double> size = {});

}  // namespace trocar
