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
};

/// Finds which vertices are inside the tool and which facets cross it. The organ is split into patches of
/// neighbouring facets; FCL finds the patches near the tool, exact signs decide on their vertices and facets.
class Detector {
  public:
    /// The organ must outlive the detector.
    explicit Detector(const Organ& organ);
    ~Detector();
    Detector(const Detector&) = delete;
    Detector& operator=(const Detector&) = delete;

    /// Tests the organ at `positions` (one per vertex, mm) against the tool at the end of `motion`.
    void detect(std::span<const Vec3> positions, const Tool& tool, const ToolMotion& motion, Detected& found);

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace trocar
