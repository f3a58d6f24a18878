#include "common/geometry/mesh_formats.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "common/geometry/mesh_error.h"
#include "common/geometry/mesh_scan.h"

namespace trocar {
namespace {

constexpr Index most_entries = std::numeric_limits<Index>::max();

Vec3 read_position(MeshScanner& scanner) {
    const double x = scanner.number("coordinate x, a finite number");
    const double y = scanner.number("coordinate y, a finite number");
    const double z = scanner.number("coordinate z, a finite number");
    return {x, y, z};
}

void require_triangle(const MeshScanner& scanner, std::int64_t corners) {
    if (corners == 3) return;
    scanner.fail(fmt::format("expected a triangle, found a facet with {} corners: triangulate the mesh first",
                             corners));
}

// OFF, or that with letters in front for what else a vertex has, all of which follows its coordinates.
void read_off_keyword(MeshScanner& scanner) {
    std::string_view word = scanner.word("the word OFF");
    for (const std::string_view extra : {"ST", "C", "N"}) {
        if (word.starts_with(extra)) word.remove_prefix(extra.size());
    }
    if (word != "OFF") scanner.fail_expected("the word OFF");
}

struct OffCounts {
    std::int64_t vertices, facets;
};

OffCounts read_off_counts(MeshScanner& scanner) {
    if (!scanner.line_has_more() && !scanner.next_line()) {
        scanner.fail_at_end("the numbers of vertices and facets");
    }
    const std::int64_t vertices = scanner.integer("the number of vertices");
    const std::int64_t facets = scanner.integer("the number of facets");
    return {vertices, facets};
}

// Faces may come before the vertices they name, so their numbers are checked at the end.
struct ObjFacet {
    Facet corners;
    std::size_t line;
};

std::int64_t read_obj_corner(MeshScanner& scanner, std::size_t vertices_so_far) {
    const auto known = static_cast<std::int64_t>(vertices_so_far);
    const std::int64_t number = scanner.integer("a vertex number, counted from 1,", -known, most_entries);
    if (number == 0) scanner.fail_expected("a vertex number, counted from 1 (or from -1 backwards)");
    return number > 0 ? number - 1 : known + number;
}

}  // namespace

SurfaceMesh parse_off(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    if (!scanner.next_line()) scanner.fail_at_end("the word OFF");
    read_off_keyword(scanner);
    const OffCounts counts = read_off_counts(scanner);

    SurfaceMesh mesh;
    // The header is not believed where the file is too short for it: a wrong one must not cost memory.
    constexpr std::size_t shortest_line = 6;  // bytes of "0 0 0" and what ends it
    const auto most_lines = static_cast<std::int64_t>(scanner.bytes_left() / shortest_line);
    mesh.positions.reserve(std::min(counts.vertices, most_lines));
    mesh.facets.reserve(std::min(counts.facets, most_lines));
    for (std::int64_t i = 0; i < counts.vertices; ++i) {
        if (!scanner.next_line()) scanner.fail_at_end(fmt::format("vertex {} of {}", i + 1, counts.vertices));
        mesh.positions.push_back(read_position(scanner));
    }
    for (std::int64_t i = 0; i < counts.facets; ++i) {
        if (!scanner.next_line()) scanner.fail_at_end(fmt::format("facet {} of {}", i + 1, counts.facets));
        require_triangle(scanner, scanner.integer("a facet's number of corners"));
        Facet& facet = mesh.facets.emplace_back();
        for (Index& corner : facet) {
            corner = static_cast<Index>(scanner.integer("a vertex number", 0, counts.vertices - 1));
        }
    }
    return mesh;
}

SurfaceMesh parse_obj(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    SurfaceMesh mesh;
    std::vector<std::size_t> lines;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "v") mesh.positions.push_back(read_position(scanner));
        if (keyword != "f") continue;
        Facet& facet = mesh.facets.emplace_back();
        lines.push_back(scanner.line());
        std::size_t corners = 0;
        for (; scanner.line_has_more(); ++corners) {
            const std::int64_t vertex = read_obj_corner(scanner, mesh.positions.size());
            if (corners < facet.size()) facet[corners] = static_cast<Index>(vertex);
        }
        require_triangle(scanner, static_cast<std::int64_t>(corners));
    }
    for (std::size_t f = 0; f < lines.size(); ++f) {
        for (const Index vertex : mesh.facets[f]) {
            if (static_cast<std::size_t>(vertex) < mesh.positions.size()) continue;
            throw MeshError(fmt::format("{}:{}: expected a vertex number from 1 to {}, found {}", file,
                                        lines[f], mesh.positions.size(), std::int64_t{vertex} + 1));
        }
    }
    return mesh;
}

}  // namespace trocar
