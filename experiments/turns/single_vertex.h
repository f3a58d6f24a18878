#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/cycle/contact.h"
#include "common/cycle/cycle.h"
#include "common/geometry/organ.h"
#include "common/tool/tool.h"

namespace trocar::turns {

/// One vertex of an organ, number 0, inside a tool, and the facets around it: all that a strategy that treats
/// vertices apart looks at. The tool stands upright with its tip at the origin when its motion ends, so that
/// nothing but where it came from has to change for v_m to change.
struct SingleVertex {
    std::shared_ptr<const Tool> tool;
    Organ organ;                 ///< an open patch: the vertex and the corners around it, edges of 2 to 5 mm
    Vec3 first_motion;           ///< unit: the direction in which the walk of motions begins
    Vec3 first_side;             ///< unit, across it: to where the walk turns first
    Vec3 line;                   ///< unit: along which the vertex is moved through the tool
    std::vector<Index> numbers;  ///< 0, 1, … of the patch's vertices
    std::vector<Vec3> velocities;  ///< of the patch's vertices, mm/s: zero
};

/// Draws one: 5 to 7 facets, whose edges at the vertex rise or fall by up to 75° from a plane of random
/// direction; the vertex at a random place within 3.5 mm of the axis and 0.3 to 12 mm above the flat end.
/// @param tool upright, with room for that, such as prism-12
SingleVertex draw_single_vertex(std::shared_ptr<const Tool> tool, std::uint64_t seed);

/// What a strategy is given: the vertex alone has collided; its corners count as free wherever they are.
struct SingleVertexInput {
    Vec3 motion;                      ///< v_m, unit
    std::span<const Vec3> positions;  ///< of the patch's vertices, mm
};

/// Calls `use(contact)` with the vertex as a strategy meets it: the tool moved 1 mm along `input.motion`.
template <typename Use>
auto with_contact(const SingleVertex& vertex, const SingleVertexInput& input, const Use& use) {
    const Pose after, before{.rotation = Mat3::Identity(), .position = -input.motion};
    const PlacedTool tool(*vertex.tool, after);
    const ToolMotion motion(before, after);
    const CycleSettings cycle;
    const auto vertices = std::span(vertex.numbers);
    const auto facets = vertices.first(vertices.size() - 1);  // as many as corners
    return use(Contact{.organ = vertex.organ,
                       .positions = input.positions,
                       .velocities = vertex.velocities,
                       .tool = tool,
                       .motion = motion,
                       .collided = vertices.first(1),
                       .crossed = facets,
                       .near_vertices = vertices,
                       .near_facets = facets,
                       .clearance = cycle.clearance,
                       .dt = cycle.dt()});
}

}  // namespace trocar::turns
