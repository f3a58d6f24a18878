#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/geometry/mesh_formats.h"
#include "common/geometry/mesh_scan.h"

// CGAL takes a wrong header for right and then allocates without limit, reads through a null pointer, or
// answers "success" for half a mesh. So it gets a header written here, with nothing in it but what was
// understood.

namespace trocar {
namespace {

constexpr std::array<std::string_view, 16> types = {
    "float", "float32", "double", "float64", "char", "int8",  "uchar", "uint8",
    "short", "int16",   "ushort", "uint16",  "int",  "int32", "uint",  "uint32"};

void require_type(const MeshScanner& scanner, std::string_view type) {
    if (std::ranges::find(types, type) == types.end())
        scanner.fail_expected("a type such as float, double, uchar or int");
}

// The rest of a list's line, anew.
std::string read_list(MeshScanner& scanner, std::string_view element) {
    const std::string_view length = scanner.word("a type");
    if (length != "uchar" && length != "uint8") {
        scanner.fail_expected(
            "uchar as the type of a list's length (save the mesh again from another program)");
    }
    const std::string_view type = scanner.word("a type");
    require_type(scanner, type);
    const std::string_view name = scanner.word("a property's name");
    const bool corners = element == "face" && (name == "vertex_indices" || name == "vertex_index");
    return fmt::format("property list uchar {} {}\n", type, corners ? "vertex_indices" : "other");
}

// The rest of a property's line, anew. What is not needed is read all the same, under a name without meaning.
std::string read_property(MeshScanner& scanner, std::string_view element) {
    if (element.empty()) scanner.fail_expected("an element before its first property");
    const std::string_view type = scanner.word("a type");
    if (type == "list") return read_list(scanner, element);
    require_type(scanner, type);
    const std::string_view name = scanner.word("a property's name");
    const bool coordinate = element == "vertex" && (name == "x" || name == "y" || name == "z");
    if (coordinate && !type.starts_with("float") && !type.starts_with("double")) {
        scanner.fail(fmt::format("expected coordinates of type float or double, found {}", type));
    }
    return fmt::format("property {} {}\n", type, coordinate ? name : "other");
}

struct Header {
    std::int64_t vertices = -1, facets = -1;  // −1 before their element was met
    std::string format, elements;             // lines, anew
};

Header read_header(MeshScanner& scanner) {
    if (!scanner.next_line() || scanner.word("the word ply") != "ply") scanner.fail_expected("the word ply");
    Header header;
    std::string_view element;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "end_header") return header;
        if (keyword == "format") {
            header.format = fmt::format("format {} 1.0\n", scanner.word("an encoding"));
        } else if (keyword == "element") {
            element = scanner.word("an element's name");
            std::int64_t& count = element == "vertex" ? header.vertices : header.facets;
            if ((element != "vertex" && element != "face") || count != -1) {
                scanner.fail("expected two elements, vertex and face, each once");
            }
            count = scanner.integer("the number of elements");
            header.elements += fmt::format("element {} {}\n", element, count);
        } else if (keyword == "property") {
            header.elements += read_property(scanner, element);
        } else if (keyword != "comment" && keyword != "obj_info") {
            scanner.fail_expected("format, element, property, comment or end_header");
        }
    }
    scanner.fail_at_end("end_header");
}

}  // namespace

MeshText prepare_ply(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    const auto [vertices, facets, format, elements] = read_header(scanner);
    for (const std::string_view needed : {" x\n", " y\n", " z\n"}) {
        if (elements.find(needed) != std::string::npos) continue;
        scanner.fail("expected vertices with properties x, y and z before end_header");
    }
    if (elements.find("vertex_indices") == std::string::npos) {
        scanner.fail("expected faces with the property \"list uchar int vertex_indices\" before end_header");
    }
    if (format.empty()) scanner.fail("expected a line such as \"format ascii 1.0\" before end_header");
    return {fmt::format("ply\n{}{}end_header\n{}", format, elements, scanner.rest()),
            static_cast<std::size_t>(facets)};
}

}  // namespace trocar
