#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Vertices>;

// In [-1, 1], a different one for each counter, the same in every run: splitmix64 (Steele, Lea and Flood
// 2014).
double noise(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

double mean_edge(const std::vector<Vec3>& positions, std::span<const Edge> edges) {
    double sum = 0;
    for (const auto& [a, b] : edges) sum += (positions[a] - positions[b]).norm();
    return sum / static_cast<double>(edges.size());
}

// Points of a flat square of that size: evenly along its sides, and inside on rows shifted by half a column
// from one to the next, each then moved at random by up to a sixth of a column in x and y.
std::vector<Vec3> scattered_points(double size, double edge) {
    const auto rows = static_cast<Index>(std::lround(size / (edge * std::numbers::sqrt3 / 2)));
    const auto columns =
        static_cast<Index>(std::lround(size * size / (edge * edge * std::numbers::sqrt3 / 2 * rows)));
    const double half = size / 2, width = size / columns, height = size / rows;
    std::vector<Vec3> points;
    for (Index row = 0; row <= rows; ++row) {
        const double y = row == rows ? half : row * height - half;
        const bool at_side = row == 0 || row == rows;
        const double start = at_side ? 1 : row % 2 == 0 ? 0.75 : 1.25;
        points.emplace_back(-half, y, 0);
        for (Index i = 0; i + 1 < columns; ++i) {
            Vec3 point((start + i) * width - half, y, 0);
            if (!at_side)
                point += 0.17 * width * Vec3(noise(2 * points.size()), noise(2 * points.size() + 1), 0);
            points.push_back(point);
        }
        points.emplace_back(half, y, 0);
    }
    return points;
}

std::vector<Facet> triangulate(const std::vector<Vec3>& points) {
    std::vector<std::pair<Kernel::Point_2, Index>> numbered;
    for (const Vec3& p : points) numbered.emplace_back(Kernel::Point_2(p.x(), p.y()), numbered.size());
    const Delaunay delaunay(numbered.begin(), numbered.end());
    std::vector<Facet> facets;
    for (const auto face : delaunay.finite_face_handles()) {
        facets.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return facets;
}

// How much of the relief is left at a place this far inside the border: none at the border itself.
double fade(double inside) {
    const double t = std::clamp(inside, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// x and y in units of the square's size.
double hills(double x, double y) {
    constexpr double turn = 2 * std::numbers::pi;
    return 0.02 * std::sin(turn * 2.4 * x + 0.6) * std::cos(turn * 1.9 * y) +
           0.015 * std::sin(turn * (1.1 * x + 1.7 * y) + 1);
}

}  // namespace

// Facets are a little smaller than those of `sheet` seen from above; how rough it is then follows from the
// mean length of the edges, which is that of `sheet`.
Organ make_rough_sheet(std::string name, double edge, double size) {
    const SurfaceMesh sheet = sheet_mesh(edge, size);
    const double wanted = mean_edge(sheet.positions, Adjacency(sheet.positions.size(), sheet.facets).edges());

    const std::vector<Vec3> flat = scattered_points(size, 0.93 * wanted);
    SurfaceMesh mesh{.positions = flat, .facets = triangulate(flat)};
    const Adjacency adjacency(flat.size(), mesh.facets);
    const auto raise = [&](double roughness) {
        for (std::size_t v = 0; v < flat.size(); ++v) {
            const Vec3& p = flat[v];
            const double inside = size / 2 - p.cwiseAbs().maxCoeff();
            mesh.positions[v].z() = fade(inside / (0.1 * size)) * size * hills(p.x() / size, p.y() / size) +
                                    fade(inside / wanted) * roughness * noise(2 * flat.size() + v);
        }
    };
    double low = 0, high = wanted;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        raise(middle);
        (mean_edge(mesh.positions, adjacency.edges()) < wanted ? low : high) = middle;
    }
    Organ organ = make_organ(std::move(name), std::move(mesh));
    organ.outline = {.half_x = size / 2, .half_y = size / 2};
    return organ;
}

}  // namespace trocar
