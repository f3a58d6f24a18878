#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {

// Vertices of rows of odd number are shifted by half an edge, with one more at each border to keep it
// straight.
SurfaceMesh sheet_mesh(double edge, double size) {
    const auto columns = static_cast<Index>(std::lround(size / edge));
    const auto rows = static_cast<Index>(std::lround(size / (edge * std::numbers::sqrt3 / 2)));
    const double half = size / 2;

    SurfaceMesh mesh;
    std::vector<Index> row_start;
    for (Index row = 0; row <= rows; ++row) {
        row_start.push_back(static_cast<Index>(mesh.positions.size()));
        const double y = size * row / rows - half;
        const bool shifted = row % 2 == 1;
        mesh.positions.emplace_back(-half, y, 0);
        for (Index i = shifted ? 0 : 1; i < columns; ++i) {
            mesh.positions.emplace_back(size * (i + (shifted ? 0.5 : 0.0)) / columns - half, y, 0);
        }
        mesh.positions.emplace_back(half, y, 0);
    }
    for (Index row = 0; row < rows; ++row) {
        const bool shifted_above = row % 2 == 0;
        const Index plain = row_start[shifted_above ? row : row + 1];
        const Index shifted = row_start[shifted_above ? row + 1 : row];
        const auto add = [&](Index a, Index b, Index c) {
            mesh.facets.push_back(shifted_above ? Facet{a, b, c} : Facet{a, c, b});
        };
        for (Index i = 0; i <= columns; ++i) {
            add(plain + i, shifted + i + 1, shifted + i);
            if (i < columns) add(plain + i, plain + i + 1, shifted + i + 1);
        }
    }
    return mesh;
}

Organ make_sheet(std::string name, double edge, double size) {
    Organ organ = make_organ(std::move(name), sheet_mesh(edge, size));
    organ.outline = {.half_x = size / 2, .half_y = size / 2};
    return organ;
}

}  // namespace trocar
