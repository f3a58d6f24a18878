#pragma once

#include <span>
#include <vector>

#include "common/geometry/predicates.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Volumes within the tool, as rays along its axis see them, mm³.
struct SeenVolumes {
    double inside = 0;  ///< where the organ's winding number w is at least 1
    double excess = 0;  ///< ∫ (w − [w ≥ 1]) dV: what w counts too much where the surface crosses itself
    double ambiguous = 0;  ///< ∫ |w − [w ≥ 1]| dV
};

/// Some 4,000 rays along the tool's axis (+z) that fill its cross-section evenly, on a lattice that is in
/// line with none of its faces.
class ToolRays {
  public:
    /// @param tool closed
    explicit ToolRays(const SurfaceMesh& tool);

    /// @param organ_facets in the tool's frame; all that lie above some part of the tool
    [[nodiscard]] SeenVolumes look(std::span<const Corners> organ_facets) const;

  private:
    struct Interval {
        double low, high;  // mm
    };

    std::vector<Vec3> rays_;                        // a point of each that meets the tool, ascending by x
    std::vector<std::vector<Interval>> intervals_;  // of z within the tool, of each ray
    double cell_ = 0;                               // a ray stands for this area, mm²
};

}  // namespace trocar
