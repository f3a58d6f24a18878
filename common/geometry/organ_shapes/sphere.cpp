#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {
namespace {

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

}  // namespace

Organ make_sphere(std::string name, double edge, double size) {
    // As many equilateral facets of that edge as cover the sphere's area.
    const double facets = std::numbers::pi * size * size / (std::numbers::sqrt3 / 4 * edge * edge);
    const double cuts = std::max(1.0, std::round(std::sqrt(facets / 20)));
    SurfaceMesh mesh = CutIcosahedron(static_cast<Index>(cuts)).take();
    for (Vec3& position : mesh.positions) position *= size / 2 / position.norm();
    return make_organ(std::move(name), std::move(mesh));
}

}  // namespace trocar
