#pragma once

#include "experiments/metrics/examples/example.h"

/// What the made-up organs and tools of examples are put together from.
namespace trocar::examples {

/// A flat sheet in the plane z = 0 with the outer side up: columns × rows vertices, `edge` (mm) apart along x
/// and y. Every square of it has a diagonal from its lower left to its upper right corner.
struct Patch {
    int columns = 0, rows = 0;
    double edge = 0;
    double x = 0, y = 0;  ///< of its vertex at column 0, row 0, mm

    [[nodiscard]] Index vertex(int column, int row) const { return row * columns + column; }
    /// @{
    /// The facets of a square, by its lower left vertex: that below the diagonal and that above it.
    [[nodiscard]] Index lower(int column, int row) const { return 2 * (row * (columns - 1) + column); }
    [[nodiscard]] Index upper(int column, int row) const { return lower(column, row) + 1; }
    /// @}
    [[nodiscard]] Organ organ() const;
};

/// A sheet of such squares whose middle is the origin.
Patch centred_patch(int vertices_across, double edge);

/// The mesh of a box from `low` to `high` (mm), two facets on each side.
SurfaceMesh box(const Vec3& low, const Vec3& high);

/// A tool that is a box: its flat end at z = 0, its axis in the middle, mm.
Tool bar(double width_x, double width_y, double length);

/// A tool that stands upright with its tip at a point.
Pose tip_at(double x, double y, double z);

/// The vertices of the example's organ that are inside the tool before handling.
std::vector<Index> collided(const Example& example);

/// Two panels, before and after handling, with arrows between them; the marks are on the second.
void show_handling(Example& example, Marks marks);

}  // namespace trocar::examples
