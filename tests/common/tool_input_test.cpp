#include "common/tool/tool_input.h"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

/// A file of the mesh, removed afterwards.
class MeshFile {
  public:
    explicit MeshFile(const SurfaceMesh& mesh)
        : path_(fs::temp_directory_path() /
                ("trocar-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
                 ".off")) {
        std::ofstream stream(path_);
        stream.precision(17);
        stream << "OFF\n" << mesh.positions.size() << ' ' << mesh.facets.size() << " 0\n";
        for (const Vec3& p : mesh.positions) stream << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        for (const auto& [a, b, c] : mesh.facets) stream << "3 " << a << ' ' << b << ' ' << c << '\n';
    }
    ~MeshFile() { fs::remove(path_); }
    MeshFile(const MeshFile&) = delete;
    MeshFile& operator=(const MeshFile&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string error_of(const fs::path& file, const ToolPlacement& placement) {
    try {
        read_tool(file, placement);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "it was accepted";
}

TEST(ToolInput, TurnsItsAxisUprightAndPutsItsTipAtTheOrigin) {
    const Tool needle = make_needle();
    for (const double angle : {0.0, 1.0, 1.6, 3.0, std::numbers::pi - 1e-7, std::numbers::pi}) {
        // Lay the needle with its tip at (5, -3, 70), in another unit of length.
        const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(3, 4, 0) / 5).toRotationMatrix();
        const Vec3 axis = 2 * turn.col(2);
        SurfaceMesh laid = needle.mesh;
        for (Vec3& position : laid.positions) position = turn * position / 25.4 + Vec3(5, -3, 70);
        const MeshFile file(laid);
        const double size = 25.4 * bounding_box(laid.positions).size().maxCoeff();
        for (const auto& tip : {std::optional<Vec3>(), std::optional<Vec3>({5, -3, 70})}) {
            const Tool tool = read_tool(file.path(), {.axis = axis, .tip = tip, .size = size}).tool;
            EXPECT_NEAR(tool.radius, 0.75, 1e-9) << angle;
            EXPECT_NEAR(tool.solid.support(-Vec3::UnitZ()).norm(), 0, 1e-9) << angle;
            EXPECT_NEAR(tool.solid.support(Vec3::UnitZ()).z(), 80, 1e-9) << angle;
            EXPECT_NEAR(signed_volume(tool.mesh), signed_volume(needle.mesh), 1e-6) << "not mirrored";
        }
    }
}

TEST(ToolInput, AlongTheFilesOwnZAxisKeepsEveryCoordinate) {
    const Tool grasper = make_grasper();
    const MeshFile file(grasper.mesh);
    const Tool tool = read_tool(file.path(), {.axis = {0, 0, 1}, .tip = Vec3(0, 0, 0)}).tool;
    EXPECT_EQ(tool.mesh.positions, grasper.mesh.positions);
    EXPECT_EQ(tool.name, file.path().stem().string());
    EXPECT_EQ(tool.solid.face_count(), grasper.solid.face_count());
    const Tool placed = read_tool(file.path(), {.axis = {0, 0, 1}}).tool;
    EXPECT_NEAR(placed.solid.box().low.z(), 0, 1e-12) << "the lowest point, between the jaws";
    EXPECT_NEAR(placed.radius, grasper.radius, 1e-9);
}

TEST(ToolInput, TakesTheLineThroughTheCentroidOfTheVolume) {
    // A pyramid of height 3: its centroid is at a quarter of that, the mean of its corners is not.
    const MeshFile file({{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 3}},
                         {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
    const Tool tool = read_tool(file.path(), {.axis = {1, 0, 0}}).tool;
    EXPECT_TRUE(tool.solid.support(-Vec3::UnitX()).isApprox(Vec3(-2.25, 0, 1), 1e-12));
}

TEST(ToolInput, RefusesWhatIsNoTool) {
    SurfaceMesh open = make_prism(6).mesh;
    open.facets.pop_back();
    const MeshFile file(open);
    EXPECT_THAT(error_of(file.path(), {.axis = {0, 0, 1}}), testing::HasSubstr("boundary"));
    EXPECT_THAT(error_of(file.path(), {.axis = {0, 0, 1}}), testing::StartsWith(file.path().string()));
    EXPECT_THAT(error_of(file.path(), {.axis = {0, 0, 0}}), testing::HasSubstr("expected a direction"));
    EXPECT_THAT(error_of("none.off", {.axis = {0, 0, 1}}), testing::HasSubstr("no such file"));
}

TEST(ToolInput, MendsASurfaceThatIsInsideOut) {
    SurfaceMesh inward = make_prism(6).mesh;
    for (Facet& facet : inward.facets) std::swap(facet[0], facet[1]);
    const MeshFile file(inward);
    const ToolInput input = read_tool(file.path(), {.axis = {0, 0, 1}});
    EXPECT_EQ(input.findings.size(), 1U);
    EXPECT_TRUE(input.tool.solid.contains({0, 0, 40}));
}

}  // namespace
}  // namespace trocar
