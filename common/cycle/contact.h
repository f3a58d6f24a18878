#pragma once

#include <span>
#include <vector>

#include "common/deformation/constraints.h"
#include "common/geometry/organ.h"
#include "common/tool/tool.h"
#include "common/tool/tool_motion.h"

namespace trocar {

/// What a strategy is given in a step: the world as detection left it. All spans are read-only views that
/// live as long as the call.
struct Contact {
    const Organ& organ;                ///< rest shape, rest normals, adjacency
    std::span<const Vec3> positions;   ///< of every organ vertex as the step found it, mm
    std::span<const Vec3> velocities;  ///< of every organ vertex, mm/s
    const PlacedTool& tool;            ///< at the end of its motion: solid queries, axis
    const ToolMotion& motion;          ///< of the tool in this step
    std::span<const Index> collided;   ///< C: vertices strictly inside the tool, ascending
    std::span<const Index> crossed;    ///< F: interpenetrated facets (they cross the tool's surface or have
                                       ///< a vertex in C), ascending
    std::span<const Index> near_vertices;  ///< vertices near the box that the tool swept, ascending
    std::span<const Index> near_facets;    ///< facets near the box that the tool swept, ascending
    double clearance;                      ///< g: how far outside the tool a vertex is put, mm
    double dt;                             ///< length of the step, s
};

/// A vertex is moved by this much (mm) at once and stays put for the step.
struct VertexDisplacement {
    Index vertex;
    Vec3 displacement;
};

/// What a strategy answers, for any organ vertices, collided or not. A vertex has at most one
/// displacement and one force.
struct Response {
    std::vector<VertexDisplacement> displacements;
    std::vector<VertexForce> forces;
    std::vector<HalfSpace> half_spaces;
    std::int64_t fallbacks = 0;  ///< directions the strategy could not form and replaced

    /// Empties the lists and keeps their memory.
    void clear() {
        displacements.clear();
        forces.clear();
        half_spaces.clear();
        fallbacks = 0;
    }
};

}  // namespace trocar
