#include <array>
#include <cstdint>
#include <exception>
#include <optional>
#include <sstream>
#include <utility>

#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include "common/geometry/mesh_error.h"
#include "common/geometry/mesh_formats.h"
#include "common/geometry/mesh_scan.h"

// CGAL reads PLY, but it trusts the header: a wrong one makes it allocate without limit, read through a null
// pointer, or answer "success" for half a mesh. So the header is checked here first, and the result
// afterwards.

namespace trocar {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

struct Header {
    bool text = false;
    std::int64_t vertices = -1, facets = -1;  // −1 before their element was met
    int coordinates = 0;                      // how many of x, y, z are there
    bool corners = false;                     // the list of a facet's vertices is there
    double shortest_body = 0;                 // bytes
};

std::size_t type_size(MeshScanner& scanner) {
    struct Type {
        std::string_view name, other_name;
        std::size_t size;
    };
    static constexpr std::array types = {
        Type{"char", "int8", 1},     Type{"uchar", "uint8", 1},    Type{"short", "int16", 2},
        Type{"ushort", "uint16", 2}, Type{"int", "int32", 4},      Type{"uint", "uint32", 4},
        Type{"float", "float32", 4}, Type{"double", "float64", 8},
    };
    const std::string_view word = scanner.word("a type such as float");
    for (const Type& type : types) {
        if (word == type.name || word == type.other_name) return type.size;
    }
    scanner.fail_expected("a type such as float, double, uchar or int");
}

// Reads the rest of a property's line. Answers the fewest bytes that it takes in a binary file.
std::size_t read_property(MeshScanner& scanner, std::string_view element, Header& header) {
    MeshScanner ahead = scanner;
    const std::string_view type = ahead.word("a type");
    if (element.empty()) scanner.fail_expected("an element before its first property");
    if (type != "list") {
        const std::size_t size = type_size(scanner);
        const std::string_view name = scanner.word("a property's name");
        if (element == "vertex" && (name == "x" || name == "y" || name == "z")) {
            if (!type.starts_with("float") && !type.starts_with("double")) {
                scanner.fail(fmt::format("expected coordinates of type float or double, found {}", type));
            }
            ++header.coordinates;
        }
        return size;
    }
    scanner.word("list");
    if (element == "vertex") scanner.fail_expected("a single value for each vertex");
    if (type_size(scanner) != 1) {
        scanner.fail_expected(
            "uchar as the type of a list's length (save the mesh again from another program)");
    }
    const std::size_t size = type_size(scanner);
    const std::string_view name = scanner.word("a property's name");
    if (element == "face" && (name == "vertex_indices" || name == "vertex_index")) {
        if (size != sizeof(std::int32_t)) scanner.fail("expected vertex numbers of type int or uint");
        header.corners = true;
    }
    return 1;
}

Header read_header(MeshScanner& scanner) {
    Header header;
    if (!scanner.next_line() || scanner.word("the word ply") != "ply") scanner.fail_expected("the word ply");
    std::string_view element;
    std::int64_t count = 0;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "end_header") return header;
        if (keyword == "format") {
            static constexpr std::string_view formats = "ascii, binary_little_endian or binary_big_endian";
            const std::string_view word = scanner.word(formats);
            header.text = word == "ascii";
            if (!header.text && word != "binary_little_endian" && word != "binary_big_endian") {
                scanner.fail_expected(formats);
            }
        } else if (keyword == "element") {
            element = scanner.word("an element's name");
            count = scanner.integer("the number of elements");
            std::int64_t& known = element == "vertex" ? header.vertices : header.facets;
            if ((element != "vertex" && element != "face") || known != -1) {
                scanner.fail("expected two elements, vertex and face, each once");
            }
            known = count;
        } else if (keyword == "property") {
            const std::size_t size = read_property(scanner, element, header);
            constexpr double shortest_text = 2;  // bytes: a digit and a blank
            header.shortest_body +=
                static_cast<double>(count) * (header.text ? shortest_text : static_cast<double>(size));
        } else if (keyword != "comment" && keyword != "obj_info") {
            scanner.fail_expected("format, element, property, comment or end_header");
        }
    }
    scanner.fail_at_end("end_header");
}

void check_header(const Header& header, const MeshScanner& scanner) {
    if (header.coordinates != 3)
        scanner.fail("expected vertices with properties x, y and z before end_header");
    if (!header.corners) {
        scanner.fail("expected faces with the property \"list uchar int vertex_indices\" before end_header");
    }
    const auto left = static_cast<double>(scanner.bytes_left());
    if (header.shortest_body > left + 1) {
        scanner.fail(
            fmt::format("{} vertices and {} facets take at least {:.0f} bytes, but only {:.0f} follow: the "
                        "file is cut off or these numbers are wrong",
                        header.vertices, header.facets, header.shortest_body, left));
    }
}

Facet to_facet(const std::string& file, std::size_t number, const Polygon& polygon,
               std::size_t vertex_count) {
    Facet facet{};
    if (polygon.size() != facet.size()) {
        throw MeshError(
            fmt::format("{}: facet {} (counted from 0): expected a triangle, found {} corners: triangulate "
                        "the mesh first",
                        file, number, polygon.size()));
    }
    for (std::size_t k = 0; k < facet.size(); ++k) {
        if (polygon[k] >= vertex_count) {
            throw MeshError(
                fmt::format("{}: facet {} (counted from 0): expected vertex numbers from 0 to {}, found {}",
                            file, number, vertex_count - 1, static_cast<std::int32_t>(polygon[k])));
        }
        facet[k] = static_cast<Index>(polygon[k]);
    }
    return facet;
}

}  // namespace

SurfaceMesh parse_ply(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    const Header header = read_header(scanner);
    check_header(header, scanner);

    std::istringstream stream{std::string(content)};
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    const bool read = CGAL::IO::read_PLY(stream, points, polygons, CGAL::parameters::verbose(false));
    if (!read || std::cmp_not_equal(points.size(), header.vertices) ||
        std::cmp_not_equal(polygons.size(), header.facets)) {
        throw MeshError(
            fmt::format("{}: expected {} vertices and {} facets, could read {} and {}: the file is cut off, "
                        "or what follows is no number",
                        file, header.vertices, header.facets, points.size(), polygons.size()));
    }

    SurfaceMesh mesh;
    for (const Point& point : points) {
        const Vec3& position = mesh.positions.emplace_back(point.x(), point.y(), point.z());
        if (position.allFinite()) continue;
        throw MeshError(
            fmt::format("{}: vertex {} (counted from 0): expected finite coordinates, found ({}, {}, {})",
                        file, mesh.positions.size() - 1, point.x(), point.y(), point.z()));
    }
    for (const Polygon& polygon : polygons) {
        mesh.facets.push_back(to_facet(file, mesh.facets.size(), polygon, points.size()));
    }
    return mesh;
}

}  // namespace trocar
