#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/geometry/mesh_input.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

// Meshes of organs and other things that are too large for this tree: the folder TROCAR_MESHES, or the one
// beside the sources. Its table README.tsv says what they are.
fs::path folder_of_meshes() {
    const char* named = std::getenv("TROCAR_MESHES");
    return named != nullptr ? fs::path(named) : fs::path(TROCAR_SOURCE_DIR) / "../shared/meshes";
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '\t');) cells.push_back(cell);
    return cells;
}

// Each line of the table as cells by the name of their column.
std::vector<std::map<std::string, std::string>> real_meshes() {
    std::ifstream table(folder_of_meshes() / "README.tsv");
    std::string line;
    std::getline(table, line);
    const std::vector<std::string> columns = cells_of(line);
    std::vector<std::map<std::string, std::string>> meshes;
    while (std::getline(table, line)) {
        const std::vector<std::string> cells = cells_of(line);
        for (auto& mesh = meshes.emplace_back(); mesh.size() < cells.size();) {
            const std::size_t column = mesh.size();
            mesh[columns.at(column)] = cells[column];
        }
    }
    return meshes;
}

TEST(RealMeshes, AreWhatTheirTableSays) {
    const auto meshes = real_meshes();
    if (meshes.empty()) GTEST_SKIP() << "no README.tsv with meshes: set TROCAR_MESHES to their folder";
    for (const auto& mesh : meshes) {
        SCOPED_TRACE(mesh.at("file"));
        SurfaceMesh read = read_mesh(folder_of_meshes() / mesh.at("file"));
        EXPECT_EQ(read.positions.size(), std::stoul(mesh.at("V")));
        EXPECT_EQ(read.facets.size(), std::stoul(mesh.at("F")));
        const double volume = std::stod(mesh.at("volume"));
        EXPECT_NEAR(signed_volume(read), volume, 1e-4 * volume);
        EXPECT_EQ(check_mesh(read).closed, mesh.at("closed") == "yes");
    }
}

TEST(RealMeshes, MakeClosedOrgansOfTheAskedSize) {
    const auto meshes = real_meshes();
    if (meshes.empty()) GTEST_SKIP() << "no README.tsv with meshes: set TROCAR_MESHES to their folder";
    for (const auto& mesh : meshes) {
        SCOPED_TRACE(mesh.at("file"));
        const OrganInput input = read_organ(folder_of_meshes() / mesh.at("file"), 100);
        EXPECT_TRUE(input.findings.empty());
        EXPECT_TRUE(input.organ.adjacency.closed());
        EXPECT_GT(signed_volume(input.organ.rest), 0);
        EXPECT_NEAR(bounding_box(input.organ.rest.positions).size().maxCoeff(), 100, 1e-9);
    }
}

}  // namespace
}  // namespace trocar
