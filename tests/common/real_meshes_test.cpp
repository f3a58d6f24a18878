#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "common/geometry/mesh_input.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

// Meshes of organs and other things that are too large for this tree: the folder TROCAR_MESHES, or the one
// beside the sources.
std::vector<fs::path> real_meshes() {
    const char* named = std::getenv("TROCAR_MESHES");
    const fs::path folder =
        named != nullptr ? fs::path(named) : fs::path(TROCAR_SOURCE_DIR) / "../shared/meshes";
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".off" || extension == ".obj") files.push_back(entry.path());
    }
    return files;
}

TEST(RealMeshes, AreReadAsCgalReadsThem) {
    const std::vector<fs::path> files = real_meshes();
    if (files.empty()) GTEST_SKIP() << "no meshes: set TROCAR_MESHES to a folder of .off and .obj files";
    for (const fs::path& file : files) {
        std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
        std::vector<std::vector<std::size_t>> polygons;
        ASSERT_TRUE(CGAL::IO::read_polygon_soup(file.string(), points, polygons)) << file;
        const SurfaceMesh mesh = read_mesh(file);
        ASSERT_EQ(mesh.positions.size(), points.size()) << file;
        ASSERT_EQ(mesh.facets.size(), polygons.size()) << file;
        for (std::size_t v = 0; v < points.size(); ++v) {
            ASSERT_EQ(mesh.positions[v], Vec3(points[v].x(), points[v].y(), points[v].z()))
                << file << " vertex " << v;
        }
        for (std::size_t f = 0; f < polygons.size(); ++f) {
            ASSERT_TRUE(std::ranges::equal(mesh.facets[f], polygons[f])) << file << " facet " << f;
        }
    }
}

TEST(RealMeshes, MakeClosedOrgansOfTheAskedSize) {
    const std::vector<fs::path> files = real_meshes();
    if (files.empty()) GTEST_SKIP() << "no meshes: set TROCAR_MESHES to a folder of .off and .obj files";
    for (const fs::path& file : files) {
        const OrganInput input = read_organ(file, 100);
        EXPECT_TRUE(input.findings.empty()) << file;
        EXPECT_TRUE(input.organ.adjacency.closed()) << file;
        EXPECT_GT(signed_volume(input.organ.rest), 0) << file;
        EXPECT_NEAR(bounding_box(input.organ.rest.positions).size().maxCoeff(), 100, 1e-9) << file;
    }
}

}  // namespace
}  // namespace trocar
