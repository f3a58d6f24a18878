#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/geometry/predicates.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// Integrates the winding number of an organ's surface over a tool. Where the surface does not cross itself
/// that is the volume of the part of the tool that is inside the organ.
///
/// A point's winding number is the number of facets straight above it (+z), those that face −z counted as
/// −1. With s = ±1 for how a facet faces, z(x, y) for its height and z₀ for any height, so
///     ∫_tool w dV = Σ_f Σ_g s_f s_g ∫ (min(z_f, z_g) − z₀) dx dy
/// over all facets f of the organ and g of the tool, each over the part of the plane that both cover. Nothing
/// is sampled and nothing decided: the result is right but for rounding.
class WindingIntegral {
  public:
    /// @param tool closed
    explicit WindingIntegral(const SurfaceMesh& tool);

    /// mm³
    /// @param organ_facets in the tool's frame; all that lie above some part of the tool
    [[nodiscard]] double over_tool(std::span<const Corners> organ_facets) const;

  private:
    struct Facet {
        Corners corners;     // counter-clockwise seen from +z
        int sign;            // −1 where it faces −z
        Box box;             // of the corners
        double z, z_x, z_y;  // of its plane: z + z_x x + z_y y is its height over z₀, mm
    };

    [[nodiscard]] static double pair(const Corners& organ_facet, const Facet& tool_facet, double base);

    std::vector<Facet> facets_;  // those that do not stand upright
    double base_;                // z₀: the lowest point, so that numbers stay small
};

}  // namespace trocar
