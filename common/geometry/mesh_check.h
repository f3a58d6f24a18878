#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Something about a mesh that its user should know.
struct Finding {
    enum class Severity {
        note,     ///< allowed
        mended,   ///< put right in the mesh
        refused,  ///< the mesh cannot be used
    };
    Severity severity;
    std::string what;   ///< such as "edges with more than two facets: 3"
    std::string where;  ///< the first few places, numbers counted from 0 as in the file; may be empty
};

/// What check_mesh found out. Lengths in mm.
struct MeshReport {
    std::size_t vertices = 0, facets = 0, edges = 0;  ///< as the mesh is after mending
    std::size_t components = 0;
    bool closed = false;
    std::optional<std::int64_t> genus;  ///< of a usable closed mesh
    Box box;
    double shortest_edge = 0, median_edge = 0, longest_edge = 0;
    double area = 0;                ///< mm²
    std::optional<double> volume;   ///< of a usable closed mesh, mm³
    std::vector<Finding> findings;  ///< the refused first, then the mended, then the notes

    [[nodiscard]] bool usable() const;
};

/// Checks whether the mesh is one manifold, consistently oriented surface of proper triangles; open ones are
/// allowed. Vertices that no facet names are dropped and a closed mesh that is inside out is turned; nothing
/// else of the mesh changes, and nothing at all when it is refused.
MeshReport check_mesh(SurfaceMesh& mesh);

/// One line: severity, what and where.
std::string describe(const Finding& finding);

/// The whole report as text, several lines, ending with whether the mesh can be used.
std::string describe(const MeshReport& report);

}  // namespace trocar
