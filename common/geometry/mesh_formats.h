#pragma once

#include <string>
#include <string_view>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Reads the content of a mesh file of each format. `file` is only named in messages. Each throws MeshError
/// at the first thing that is not as it should be; facets that are no triangles and vertex numbers out of
/// range are among them. What a format has beyond positions and facets (normals, colours, textures) is left
/// out.

/// Text OFF, and its variants with normals, colours or texture coordinates. One vertex or facet a line.
SurfaceMesh parse_off(const std::string& file, std::string_view content);

/// Wavefront OBJ; vertex numbers below zero count backwards from the vertex defined last.
SurfaceMesh parse_obj(const std::string& file, std::string_view content);

/// STL, text or binary. Corners at exactly the same position become one vertex.
SurfaceMesh parse_stl(const std::string& file, std::string_view content);

/// PLY, text or binary.
SurfaceMesh parse_ply(const std::string& file, std::string_view content);

}  // namespace trocar
