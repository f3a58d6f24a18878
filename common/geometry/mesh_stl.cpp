#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "common/geometry/mesh_error.h"
#include "common/geometry/mesh_formats.h"
#include "common/geometry/mesh_scan.h"

namespace trocar {
namespace {

constexpr std::size_t header_size = 84;  // bytes: 80 of free text, then the number of facets
constexpr std::size_t record_size = 50;  // bytes of a facet: normal, three corners, two more

// A binary file may begin with "solid" too, but none is without a zero byte.
bool is_text(std::string_view content) {
    return content.starts_with("solid") && content.find('\0') == std::string_view::npos;
}

MeshText prepare_text(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    MeshText prepared;
    bool ended = false;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        ended = keyword == "endsolid";
        if (keyword == "endfacet") ++prepared.facets;
        // CGAL would take words of a name for keywords.
        prepared.text.append(keyword == "solid" || ended ? keyword : scanner.line()).append("\n");
    }
    if (!ended) scan_stl(file, content);  // CGAL would go on to read the text as a binary file
    return prepared;
}

MeshText prepare_binary(const std::string& file, std::string_view content) {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t facets = 0;
    if (content.size() >= header_size)
        std::memcpy(&facets, &content[header_size - sizeof facets], sizeof facets);
    if (content.size() != header_size + record_size * facets) {
        throw MeshError(
            fmt::format("{}: expected STL: text that begins with \"solid\", or {} bytes and {} more for each "
                        "facet; found {} bytes with {} facets promised: it is cut off or no STL",
                        file, header_size, record_size, content.size(), facets));
    }
    for (std::size_t f = 0; f < facets; ++f) {
        std::array<float, 12> numbers{};  // normal and corners
        std::memcpy(numbers.data(), &content[header_size + record_size * f], sizeof numbers);
        if (std::all_of(numbers.begin() + 3, numbers.end(), [](float x) { return std::isfinite(x); }))
            continue;
        // CGAL would weld that corner to any other.
        throw MeshError(fmt::format("{}: facet {} (counted from 0): expected finite coordinates", file, f));
    }
    MeshText prepared{std::string(content), facets};
    std::fill_n(prepared.text.begin(), 5, 'x');  // CGAL takes what begins with "solid" for a text
    return prepared;
}

void scan_facet(MeshScanner& scanner) {
    int corners = 0;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "outer" || keyword == "endloop") continue;
        if (keyword == "endfacet" && corners == 3) return;
        if (keyword != "vertex" || corners == 3) {
            scanner.fail_expected(corners == 3 ? "endloop or endfacet after three vertices"
                                               : "vertex (a facet has three)");
        }
        scanner.position();
        ++corners;
    }
    scanner.fail_at_end("endfacet");
}

}  // namespace

MeshText prepare_stl(const std::string& file, std::string_view content) {
    return is_text(content) ? prepare_text(file, content) : prepare_binary(file, content);
}

void scan_stl(const std::string& file, std::string_view content) {
    if (!is_text(content)) return;
    MeshScanner scanner(file, content);
    bool ended = false;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        ended = keyword == "endsolid";
        if (keyword == "facet") {
            scan_facet(scanner);
        } else if (keyword != "solid" && !ended) {
            scanner.fail_expected("facet, solid or endsolid");
        }
    }
    if (!ended) scanner.fail_at_end("facet or endsolid");
}

}  // namespace trocar
