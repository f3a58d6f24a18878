#include "common/geometry/mesh_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <new>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <boost/container/static_vector.hpp>
#include <fmt/format.h>

#include "common/geometry/mesh_formats.h"

namespace trocar {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
// A fourth corner throws. CGAL makes room for as many as the file says.
using Corners = boost::container::static_vector<Index, 3>;

// What CGAL's readers fill, unchecked.
struct Soup {
    std::vector<Point> points;
    std::vector<Corners> facets;
};

struct Format {
    std::string_view extension;
    MeshText (*prepare)(const std::string& file, std::string_view content);
    bool (*read)(std::istream& stream, Soup& soup);
    void (*scan)(const std::string& file, std::string_view content);
};

constexpr std::array formats = {
    Format{".off", prepare_off,
           [](auto& stream, auto& soup) { return CGAL::IO::read_OFF(stream, soup.points, soup.facets); },
           scan_off},
    Format{".obj", prepare_obj,
           [](auto& stream, auto& soup) { return CGAL::IO::read_OBJ(stream, soup.points, soup.facets); },
           scan_obj},
    Format{".stl", prepare_stl,
           [](auto& stream, auto& soup) { return CGAL::IO::read_STL(stream, soup.points, soup.facets); },
           scan_stl},
    Format{".ply", prepare_ply,
           [](auto& stream, auto& soup) {
               return CGAL::IO::read_PLY(stream, soup.points, soup.facets, CGAL::parameters::verbose(false));
           },
           nullptr},
};

// Below this all numbers of vertices, facets and corners fit an Index.
constexpr std::uintmax_t longest_file = std::uintmax_t{4} << 30U;  // bytes

const Format& format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto* found = std::ranges::find(formats, extension, &Format::extension);
    if (found == formats.end()) {
        throw MeshError(
            fmt::format("{}: expected a mesh file ending in .off, .obj, .stl or .ply", file.string()));
    }
    return *found;
}

std::string read_file(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) throw MeshError(name + ": there is no such file");
    if (std::filesystem::is_directory(status))
        throw MeshError(name + ": expected a mesh file, found a folder");
    if (!std::filesystem::is_regular_file(status)) throw MeshError(name + ": expected a regular file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error && size > longest_file) throw MeshError(name + ": longer than 4 GiB, take a coarser mesh");

    std::ifstream stream(file, std::ios::binary);
    std::string content(error ? 0 : size, '\0');
    if (error || !stream.read(content.data(), static_cast<std::streamsize>(size))) {
        throw MeshError(name + ": cannot be read; is it yours to read?");
    }
    if (content.empty()) throw MeshError(name + ": the file is empty");
    return content;
}

// Throws MeshError where CGAL fails, or takes for a mesh what is none.
SurfaceMesh read_prepared(const std::string& file, const Format& format, MeshText prepared) {
    if (prepared.facets == 0) throw MeshError(file + ": expected triangles, found no facet");
    std::istringstream stream(std::move(prepared.text));
    Soup soup;
    bool read = true;
    try {
        read = format.read(stream, soup);
    } catch (const std::bad_alloc&) {
        read = false;  // a fourth corner; its facet stays empty
    }
    SurfaceMesh mesh;
    mesh.positions.reserve(soup.points.size());
    mesh.facets.reserve(soup.facets.size());
    for (const Point& p : soup.points) {
        if (mesh.positions.emplace_back(p.x(), p.y(), p.z()).allFinite()) continue;
        throw MeshError(fmt::format("{}: vertex {} (counted from 0): expected finite coordinates", file,
                                    mesh.positions.size() - 1));
    }
    const auto is_lost = [&](Index v) { return v < 0 || std::cmp_greater_equal(v, soup.points.size()); };
    for (const Corners& corners : soup.facets) {
        if (corners.size() != 3) {
            throw MeshError(
                fmt::format("{}: facet {} (counted from 0): expected a triangle: triangulate the mesh first",
                            file, mesh.facets.size()));
        }
        if (const auto lost = std::ranges::find_if(corners, is_lost); lost != corners.end()) {
            throw MeshError(
                fmt::format("{}: facet {} (counted from 0): expected vertex numbers from 0 to {}, found {}",
                            file, mesh.facets.size(), std::ssize(soup.points) - 1, *lost));
        }
        mesh.facets.push_back({corners[0], corners[1], corners[2]});
    }
    if (!read || mesh.facets.size() != prepared.facets) {
        throw MeshError(
            fmt::format("{}: expected {} facets, could read {} vertices and {} facets: the file is "
                        "cut off, damaged or of a kind that CGAL does not read",
                        file, prepared.facets, mesh.positions.size(), mesh.facets.size()));
    }
    return mesh;
}

}  // namespace

SurfaceMesh read_mesh(const std::filesystem::path& file) {
    const std::string name = file.string();
    const Format& format = format_of(file);
    const std::string content = read_file(file);
    MeshText prepared = format.prepare(name, content);
    try {
        return read_prepared(name, format, std::move(prepared));
    } catch (const MeshError&) {
        if (format.scan != nullptr) format.scan(name, content);
        throw;
    }
}

void scale_to_size(SurfaceMesh& mesh, double size) {
    if (!(size > 0) || !std::isfinite(size)) {
        throw MeshError(fmt::format("size {} mm: expected a positive length", size));
    }
    const double longest = bounding_box(mesh.positions).size().maxCoeff();
    if (!(longest > 0) || !std::isfinite(longest)) {
        throw MeshError("a mesh without extent cannot be scaled");
    }
    for (Vec3& position : mesh.positions) position *= size / longest;
}

CheckedMesh read_checked_mesh(const std::filesystem::path& file, std::optional<double> size) {
    SurfaceMesh mesh = read_mesh(file);
    if (size) scale_to_size(mesh, *size);
    MeshReport report = check_mesh(mesh);
    if (!report.usable()) {
        std::string message = file.string() + ": this mesh cannot be used; repair it, for example in MeshLab";
        for (const Finding& finding : report.findings) {
            if (finding.severity == Finding::Severity::refused) message += "\n  " + describe(finding);
        }
        throw MeshError(message);
    }
    return {std::move(mesh), std::move(report.findings)};
}

OrganInput read_organ(const std::filesystem::path& file, std::optional<double> size) {
    CheckedMesh checked = read_checked_mesh(file, size);
    std::string name = file.stem().string();
    if (size) name += fmt::format(" s{}", *size);
    return {make_organ(std::move(name), std::move(checked.mesh)), std::move(checked.findings)};
}

}  // namespace trocar
