#include "common/geometry/mesh_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "common/geometry/mesh_formats.h"

namespace trocar {
namespace {

struct Format {
    std::string_view extension;
    SurfaceMesh (*parse)(const std::string& file, std::string_view content);
};

constexpr std::array formats = {Format{".off", parse_off}, Format{".obj", parse_obj},
                                Format{".stl", parse_stl}, Format{".ply", parse_ply}};

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

}  // namespace

SurfaceMesh read_mesh(const std::filesystem::path& file) {
    const std::string content = read_file(file);
    SurfaceMesh mesh = format_of(file).parse(file.string(), content);
    if (mesh.facets.empty()) throw MeshError(file.string() + ": expected triangles, found no facet");
    return mesh;
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
