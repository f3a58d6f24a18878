#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include <fmt/format.h>

#include "common/geometry/mesh_error.h"
#include "common/geometry/mesh_formats.h"
#include "common/geometry/mesh_scan.h"

namespace trocar {
namespace {

constexpr std::size_t header_size = 84;  // bytes: 80 of free text, then the number of facets
constexpr std::size_t record_size = 50;  // bytes of a facet: normal, three corners, two more
constexpr std::size_t corners_offset = 12;

struct PositionHash {
    std::size_t operator()(const std::array<double, 3>& position) const {
        std::size_t hash = 0;
        for (const double coordinate : position) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

// Gives the same vertex number to the same position: STL repeats it in every facet.
class Welder {
  public:
    explicit Welder(SurfaceMesh& mesh) : mesh_(mesh) {}

    Index vertex_at(const Vec3& position) {
        // Adding zero makes −0 and 0 one and the same.
        const Vec3 plain = position + Vec3::Zero();
        const auto next = static_cast<Index>(mesh_.positions.size());
        const auto [found, is_new] = numbers_.try_emplace({plain.x(), plain.y(), plain.z()}, next);
        if (is_new) mesh_.positions.push_back(plain);
        return found->second;
    }

  private:
    SurfaceMesh& mesh_;
    std::unordered_map<std::array<double, 3>, Index, PositionHash> numbers_;
};

template <class Number>
Number little_endian(std::string_view content, std::size_t offset) {
    static_assert(std::endian::native == std::endian::little);
    Number number;
    std::memcpy(&number, content.data() + offset, sizeof number);
    return number;
}

std::size_t promised_facets(std::string_view content) {
    return content.size() < header_size ? 0 : little_endian<std::uint32_t>(content, header_size - 4);
}

bool is_binary(std::string_view content) {
    return content.size() >= header_size &&
           content.size() == header_size + record_size * promised_facets(content);
}

SurfaceMesh parse_binary(const std::string& file, std::string_view content) {
    SurfaceMesh mesh;
    Welder welder(mesh);
    for (std::size_t f = 0; f < promised_facets(content); ++f) {
        Facet& facet = mesh.facets.emplace_back();
        std::size_t offset = header_size + record_size * f + corners_offset;
        for (Index& corner : facet) {
            Vec3 position;
            for (double& coordinate : position) {
                coordinate = little_endian<float>(content, offset);
                offset += sizeof(float);
            }
            if (!position.allFinite()) {
                throw MeshError(
                    fmt::format("{}: facet {} (counted from 0): expected finite coordinates, found "
                                "({}, {}, {})",
                                file, f, position.x(), position.y(), position.z()));
            }
            corner = welder.vertex_at(position);
        }
    }
    return mesh;
}

Facet parse_facet(MeshScanner& scanner, Welder& welder) {
    Facet facet{};
    std::size_t corners = 0;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "outer" || keyword == "endloop") continue;
        if (keyword == "endfacet" && corners == facet.size()) return facet;
        if (keyword != "vertex" || corners == facet.size()) {
            scanner.fail_expected(corners == facet.size() ? "endloop or endfacet after three vertices"
                                                          : "vertex (a facet has three)");
        }
        const double x = scanner.number("coordinate x, a finite number");
        const double y = scanner.number("coordinate y, a finite number");
        const double z = scanner.number("coordinate z, a finite number");
        facet[corners++] = welder.vertex_at({x, y, z});
    }
    scanner.fail_at_end("endfacet");
}

SurfaceMesh parse_text(const std::string& file, std::string_view content) {
    MeshScanner scanner(file, content);
    SurfaceMesh mesh;
    Welder welder(mesh);
    bool ended = false;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word("a keyword");
        if (keyword == "facet") {
            mesh.facets.push_back(parse_facet(scanner, welder));
        } else if (keyword != "solid" && keyword != "endsolid") {
            scanner.fail_expected("facet, solid or endsolid");
        }
        ended = keyword == "endsolid";
    }
    if (!ended) scanner.fail_at_end("facet or endsolid");
    return mesh;
}

}  // namespace

SurfaceMesh parse_stl(const std::string& file, std::string_view content) {
    if (is_binary(content)) return parse_binary(file, content);
    if (content.starts_with("solid")) return parse_text(file, content);
    throw MeshError(
        fmt::format("{}: expected STL: text that begins with \"solid\", or {} bytes and {} more for each "
                    "facet; found {} bytes with {} facets promised: it seems to be cut off",
                    file, header_size, record_size, content.size(), promised_facets(content)));
}

}  // namespace trocar
