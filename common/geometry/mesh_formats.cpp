#include "common/geometry/mesh_formats.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "common/geometry/mesh_scan.h"

namespace trocar {
namespace {

void require_triangle(const MeshScanner& scanner, std::int64_t corners) {
    if (corners == 3) return;
    scanner.fail(fmt::format("expected a triangle, found a facet with {} corners: triangulate the mesh first",
                             corners));
}

// The numbers of vertices and facets.
std::pair<std::int64_t, std::int64_t> read_off_header(MeshScanner& scanner) {
    if (!scanner.next_line()) scanner.fail_at_end("the word OFF");
    std::string_view word = scanner.word("the word OFF");
    // Letters in front say what else a vertex has, all of which follows its coordinates.
    for (const std::string_view letters : {"ST", "C", "N"}) {
        if (word.starts_with(letters)) word.remove_prefix(letters.size());
    }
    if (word != "OFF") scanner.fail_expected("the word OFF");
    if (!scanner.line_has_more() && !scanner.next_line()) {
        scanner.fail_at_end("the numbers of vertices and facets");
    }
    const std::int64_t vertices = scanner.integer("the number of vertices");
    return {vertices, scanner.integer("the number of facets")};
}

}  // namespace

MeshText prepare_off(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    const auto [vertices, facets] = read_off_header(scanner);
    // CGAL allocates what the header says. A line takes at least "0 0 0" or "3 0 1 2" and what ends it.
    const std::string_view lines = scanner.rest();
    if (6.0 * static_cast<double>(vertices) + 8.0 * static_cast<double>(facets) >
        static_cast<double>(lines.size()) + 1) {
        scan_off(file, content);
    }
    // Told of colours, it would read past the end of a line without; not told, it skips them.
    return {fmt::format("OFF {} {} 0\n{}", vertices, facets, lines), static_cast<std::size_t>(facets)};
}

void scan_off(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    const auto [vertices, facets] = read_off_header(scanner);
    for (std::int64_t i = 1; i <= vertices; ++i) {
        if (!scanner.next_line()) scanner.fail_at_end(fmt::format("vertex {} of {}", i, vertices));
        scanner.position();
    }
    for (std::int64_t i = 1; i <= facets; ++i) {
        if (!scanner.next_line()) scanner.fail_at_end(fmt::format("facet {} of {}", i, facets));
        require_triangle(scanner, scanner.integer("a facet's number of corners"));
        for (int corner = 0; corner < 3; ++corner) scanner.integer("a vertex number", 0, vertices - 1);
    }
}

MeshText prepare_obj(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    MeshText prepared;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        // CGAL does not know every other keyword.
        if (keyword != "v" && keyword != "f") continue;
        prepared.text.append(scanner.line()).append("\n");
        if (keyword == "v") continue;
        ++prepared.facets;
        while (scanner.line_has_more()) {
            const std::string_view corner = scanner.word("a corner");
            if (corner.substr(0, corner.find('/')).find_first_not_of("+-0") != std::string_view::npos)
                continue;
            // CGAL takes 0 for the vertex that the file defines next.
            scanner.fail_expected("a vertex number from 1 (or -1)");
        }
    }
    std::ranges::replace(prepared.text, '\t', ' ');  // nor does it know other blanks between corners
    return prepared;
}

void scan_obj(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    std::int64_t vertices = 0, vertices_so_far = 0;
    for (MeshScanner ahead = scanner; ahead.next_line();) {
        if (ahead.word("a keyword") == "v") ++vertices;
    }
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "v") {
            scanner.position();
            ++vertices_so_far;
        } else if (keyword == "f") {
            std::int64_t corners = 0;
            for (; scanner.line_has_more(); ++corners) {
                scanner.integer("a vertex number", -vertices_so_far, vertices);
            }
            require_triangle(scanner, corners);
        }
    }
}

}  // namespace trocar
