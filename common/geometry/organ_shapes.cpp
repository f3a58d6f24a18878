#include "common/geometry/organ_shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "common/nearest_name.h"

namespace trocar {
namespace {

constexpr double default_edge = 4;   // mm
constexpr double most_facets = 4e6;  // a mesh beyond this is a slip of the pen, not an experiment

// How many equilateral facets of that edge cover that area, refused when the numbers make no mesh.
double facets_needed(double edge, double size, double area) {
    if (!(edge > 0) || !(size > 0) || !std::isfinite(edge) || !std::isfinite(size)) {
        throw std::invalid_argument(fmt::format("edge length {} mm: expected a positive length", edge));
    }
    if (edge > size) {
        throw std::invalid_argument(fmt::format(
            "edge length {} mm: the shape is only {} mm across, take a shorter edge", edge, size));
    }
    const double facets = area / (std::numbers::sqrt3 / 4 * edge * edge);
    if (facets > most_facets) {
        throw std::invalid_argument(fmt::format(
            "edge length {} mm: the mesh would have {:.2g} facets, more than 4 million; take a longer edge",
            edge, facets));
    }
    return facets;
}

// Vertices of rows of odd number are shifted by half an edge, with one more at each border to keep it
// straight.
SurfaceMesh make_sheet(double edge, double size) {
    facets_needed(edge, size, size * size);
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

SurfaceMesh make_icosahedron() {
    constexpr double p = std::numbers::phi;
    return {.positions = {{-1, p, 0},
                          {1, p, 0},
                          {-1, -p, 0},
                          {1, -p, 0},
                          {0, -1, p},
                          {0, 1, p},
                          {0, -1, -p},
                          {0, 1, -p},
                          {p, 0, -1},
                          {p, 0, 1},
                          {-p, 0, -1},
                          {-p, 0, 1}},
            .facets = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

// The icosahedron with each facet cut into `cuts` × `cuts` facets, not yet moved out to the sphere.
class CutIcosahedron {
  public:
    explicit CutIcosahedron(Index cuts) : cuts_(cuts), coarse_(make_icosahedron()) {
        mesh_.positions = coarse_.positions;
        cut_edges();
        for (const Facet& facet : coarse_.facets) cut_facet(facet);
    }

    SurfaceMesh take() { return std::move(mesh_); }

  private:
    Index add(const Vec3& position) {
        mesh_.positions.push_back(position);
        return static_cast<Index>(mesh_.positions.size() - 1);
    }

    // Points on edges are made once and shared by the facets on both sides.
    void cut_edges() {
        const Adjacency around(coarse_.positions.size(), coarse_.facets);
        for (const auto& [from, to] : around.edges()) {
            edge_start_[from][to] = static_cast<Index>(mesh_.positions.size());
            for (Index i = 1; i < cuts_; ++i) {
                add((coarse_.positions[from] * (cuts_ - i) + coarse_.positions[to] * i) / cuts_);
            }
        }
    }

    // The point that is `steps` of `cuts_` on the way from one corner of the icosahedron to another.
    [[nodiscard]] Index on_edge(Index from, Index to, Index steps) const {
        if (steps == 0) return from;
        if (steps == cuts_) return to;
        return from < to ? edge_start_[from][to] + steps - 1 : edge_start_[to][from] + cuts_ - steps - 1;
    }

    // Rows of points run from side ab to side ac, each one step further away from a.
    void cut_facet(const Facet& facet) {
        const auto [a, b, c] = facet;
        std::vector<Index> row = {a};
        for (Index r = 1; r <= cuts_; ++r) {
            std::vector<Index> next = {on_edge(a, b, r)};
            for (Index i = 1; i < r; ++i) {
                next.push_back(r == cuts_ ? on_edge(b, c, i)
                                          : add((coarse_.positions[a] * (cuts_ - r) +
                                                 coarse_.positions[b] * (r - i) + coarse_.positions[c] * i) /
                                                cuts_));
            }
            next.push_back(on_edge(a, c, r));
            for (Index i = 0; i < r; ++i) {
                mesh_.facets.push_back({row[i], next[i], next[i + 1]});
                if (i + 1 < r) mesh_.facets.push_back({row[i], next[i + 1], row[i + 1]});
            }
            row = std::move(next);
        }
    }

    Index cuts_;
    SurfaceMesh coarse_, mesh_;
    std::array<std::array<Index, 12>, 12> edge_start_{};
};

SurfaceMesh make_sphere(double edge, double size) {
    const double facets = facets_needed(edge, size, std::numbers::pi * size * size);
    const double cuts = std::max(1.0, std::round(std::sqrt(facets / 20)));
    SurfaceMesh mesh = CutIcosahedron(static_cast<Index>(cuts)).take();
    for (Vec3& position : mesh.positions) position *= size / 2 / position.norm();
    return mesh;
}

double parse_edge(std::string_view formula, std::string_view shape) {
    if (formula == shape) return default_edge;
    const std::string_view text = formula.substr(shape.size() + 1);
    double edge = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), edge);
    if (error != std::errc() || std::string_view(end, text.end()) != "mm") {
        throw std::invalid_argument(
            fmt::format("organ \"{}\": expected an edge length in millimetres after the @, such as {}@4mm",
                        formula, shape));
    }
    return edge;
}

}  // namespace

const std::vector<OrganShape>& all_organ_shapes() {
    static const std::vector<OrganShape> shapes = {
        {"sheet", "an open square, 120 mm wide, facing +z", 120, make_sheet},
        {"sphere", "a closed sphere, 80 mm in diameter", 80, make_sphere},
    };
    return shapes;
}

Organ make_organ_by_formula(std::string_view formula) {
    const std::string_view name = formula.substr(0, formula.find('@'));
    std::vector<std::string> names;
    for (const OrganShape& shape : all_organ_shapes()) {
        names.push_back(shape.name);
        if (shape.name != name) continue;
        const double edge = parse_edge(formula, name);
        try {
            return make_organ(fmt::format("{}@{}mm", name, edge), shape.make(edge, shape.default_size));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(fmt::format("organ \"{}\": {}", formula, error.what()));
        }
    }
    throw std::invalid_argument(unknown_name("organ", name, names));
}

}  // namespace trocar
