#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/geometry/organ.h"
#include "common/tool/tool.h"
#include "common/tool/tool_motion.h"

namespace trocar {

/// What detection found in a step; every list ascends.
struct Detected {
    std::vector<Index> collided;       ///< C: vertices strictly inside the tool
    std::vector<Index> crossed;        ///< F: facets that cross the tool's surface or have a vertex in C
    std::vector<Index> near_vertices;  ///< vertices in or near the box that the tool swept in this step
    std::vector<Index> near_facets;    ///< facets in or near that box

    /// Empties the lists and keeps their memory.
    void clear() {
        for (auto* list : {&collided, &crossed, &near_vertices, &near_facets}) list->clear();
    }
};

/// Finds which vertices are inside the tool and which facets cross it. FCL finds the organ's patches near the
/// tool, exact signs decide on their vertices and facets. It costs what has moved and what is near.
class Detector {
  public:
    /// Knows the organ at rest. The organ must outlive the detector.
    explicit Detector(const Organ& organ);
    ~Detector();
    Detector(const Detector&) = delete;
    Detector& operator=(const Detector&) = delete;

    /// Learns where the vertices of these patches of the organ are now; all others are where they were.
    /// @param positions one per vertex, mm
    void follow(std::span<const std::uint32_t> patches, std::span<const Vec3> positions);

    /// The same for an organ that may have moved everywhere.
    void follow_all(std::span<const Vec3> positions);

    /// Tests the organ at `positions` (one per vertex, mm; those followed) against the tool at the end of
    /// `motion`.
    void detect(std::span<const Vec3> positions, const Tool& tool, const ToolMotion& motion, Detected& found);

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace trocar
