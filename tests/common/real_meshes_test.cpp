#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/mesh_input.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/tool_input.h"
#include "tests/random_numbers.h"

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

TEST(RealMeshes, MakeToolsWhoseQueriesAreWhatCgalSays) {
    std::size_t tools = 0;
    for (const auto& mesh : real_meshes()) {
        if (mesh.at("kind") != "tool") continue;
        ++tools;
        SCOPED_TRACE(mesh.at("file"));
        const Tool tool = read_tool(folder_of_meshes() / mesh.at("file"), {.axis = {0, 0, 1}}).tool;
        EXPECT_FALSE(tool.solid.convex());
        EXPECT_NEAR(tool.solid.box().low.z(), 0, 1e-9);
        const SurfaceQueries oracle(tool.mesh);
        const auto depth = [&](const Vec3& at) {
            return oracle.contains(at) ? -oracle.distance(at) : oracle.distance(at);
        };
        constexpr double clearance = 0.01;
        EXPECT_TRUE(rc::check([&] {
            const Vec3 point = testing_support::random_point(tool.solid.box().grown(0.5));
            const Vec3 direction = testing_support::random_direction();
            RC_ASSERT(std::abs((tool.solid.closest(point).position - point).norm() - oracle.distance(point)) <
                      1e-9);
            RC_ASSERT(tool.solid.contains(point) == oracle.contains(point));
            const double exit = tool.solid.exit_distance(point, direction, clearance);
            RC_ASSERT(depth(point + exit * direction) > clearance - 1e-10);
            for (int k = 0; k < 5; ++k) {
                const double before = exit * testing_support::random_number(0, 0.999999);
                RC_ASSERT(exit == 0 || depth(point + before * direction) < clearance);
            }
        }));
    }
    if (tools == 0) GTEST_SKIP() << "no README.tsv with tools: set TROCAR_MESHES to their folder";
}

}  // namespace
}  // namespace trocar
