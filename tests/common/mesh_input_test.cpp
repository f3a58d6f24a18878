#include "common/geometry/mesh_input.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX
#include <sys/resource.h>

namespace trocar {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string good_off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

class MeshInput : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "trocar-meshes-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    // What reading a file of that content answers, without the folder's name.
    [[nodiscard]] std::string error_of(const std::string& name, const std::string& content) const {
        return error_of(write(name, content));
    }
    [[nodiscard]] std::string error_of(const fs::path& file) const {
        try {
            read_mesh(file);
        } catch (const MeshError& error) {
            const std::string text = error.what();
            const std::string prefix = folder_.string() + "/";
            return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
        }
        return "nothing was thrown";
    }

    void expect_tetrahedron(const std::string& name, const std::string& content) const {
        const SurfaceMesh mesh = read_mesh(write(name, content));
        ASSERT_EQ(mesh.positions.size(), 4U) << name;
        ASSERT_EQ(mesh.facets.size(), 4U) << name;
        EXPECT_DOUBLE_EQ(signed_volume(mesh), 1.0 / 6) << name;
    }

    fs::path folder_;
};

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
    const std::size_t at = text.find(old_part);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, old_part.size(), new_part);
}

template <class Number>
std::string bytes(Number number) {
    std::string text(sizeof number, '\0');
    std::memcpy(text.data(), &number, sizeof number);
    return text;
}

// The tetrahedron in other formats, from the OFF one.
std::string as_stl_text(const SurfaceMesh& mesh) {
    std::ostringstream text;
    text << "solid a name # 1\n";
    for (const Facet& facet : mesh.facets) {
        text << " facet normal 0 0 0\n  outer loop\n";
        for (const Index v : facet) text << "   vertex " << mesh.positions[v].transpose() << "\n";
        text << "  endloop\n endfacet\n";
    }
    text << "endsolid a name\n";
    return text.str();
}

std::string as_stl_binary(const SurfaceMesh& mesh) {
    std::string content = "solid endsolid but binary all the same";
    content.resize(80, ' ');
    content += bytes(static_cast<std::uint32_t>(mesh.facets.size()));
    for (const Facet& facet : mesh.facets) {
        content += std::string(12, '\0');
        for (const Index v : facet) {
            for (const double coordinate : mesh.positions[v])
                content += bytes(static_cast<float>(coordinate));
        }
        content += std::string(2, '\0');
    }
    return content;
}

const std::string ply_header =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
const std::string good_ply = ply_header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string as_ply_binary(const SurfaceMesh& mesh) {
    std::string content = replaced(ply_header, "ascii", "binary_little_endian");
    for (const Vec3& position : mesh.positions) {
        for (const double coordinate : position) content += bytes(static_cast<float>(coordinate));
    }
    for (const Facet& facet : mesh.facets) {
        content += '\3';
        for (const Index v : facet) content += bytes(v);
    }
    return content;
}

TEST_F(MeshInput, ReadsOff) {
    expect_tetrahedron("a.off", good_off);
    expect_tetrahedron("crlf.OFF",
                       "# made by hand\r\nOFF # text\r\n\r\n4 4 0\r\n0 0 0\r\n1 0 0\r\n\t0 1 0 # third\r\n"
                       "0 0 1e0\r\n3 0 2 1 255 0 0\r\n3 0 1 3\r\n3 1 2 3\r\n3 2 0 3");
    expect_tetrahedron(
        "c.off",
        "COFF 4 4 6\n0 0 0 255 0 0\n+1 0 0 0 0 0\n0 1. 0 0 0 0\n0 0 1 0 0 0\n3 0 2 1\n3 0 1 3\n"
        "3 1 2 3\n3 2 0 3\n");
}

TEST_F(MeshInput, ReadsObj) {
    expect_tetrahedron(
        "a.obj",
        "# comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvt 0 0\n"
        "usemtl skin\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf 3/1/1 1/1/1 4/1/1\n");
    expect_tetrahedron("crlf.obj",
                       "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 3 2\r\nv 0 0 1 1.0\r\nf -4 -3 -1\r\nf 2 3 4\r\n"
                       "f 3 1 4\r\n");
    expect_tetrahedron("first.obj",
                       "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
}

TEST_F(MeshInput, CountsNegativeObjNumbersBackFromTheVertexBefore) {
    const SurfaceMesh mesh =
        read_mesh(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -1 -3\n"));
    EXPECT_EQ(mesh.facets, (std::vector<Facet>{{0, 1, 2}, {0, 3, 1}}));
}

TEST_F(MeshInput, ReadsStlAndWeldsIt) {
    const SurfaceMesh mesh = read_mesh(write("a.off", good_off));
    expect_tetrahedron("text.stl", as_stl_text(mesh));
    expect_tetrahedron("binary.stl", as_stl_binary(mesh));
    expect_tetrahedron("zero.stl", replaced(as_stl_text(mesh), "vertex 0", "vertex -0.0"));
}

TEST_F(MeshInput, ReadsWhatCgalAloneWouldRefuseOrMisread) {
    // Normals and colours that are announced but missing.
    expect_tetrahedron("c.off", replaced(good_off, "OFF\n4 4 6", "STCNOFF\n4 4"));
    expect_tetrahedron("tabs.obj",
                       "v\t0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2\nf\t1\t3\t2\nf 1\t2 4\n"
                       "f 2/1\t3/2\t4\nf 3 1 4\n");
    const SurfaceMesh mesh = read_mesh(write("a.off", good_off));
    expect_tetrahedron("name.stl", replaced(as_stl_text(mesh), "solid a name", "solid a solid facet"));
    expect_tetrahedron("tab.stl", replaced(as_stl_text(mesh), "solid ", "solid\t"));
    const std::string colours =
        "property uchar red\nproperty uchar g\nproperty float green\nproperty uchar blue\n";
    std::string ply = replaced(as_ply_binary(mesh), "element face", colours + "element face");
    const std::size_t vertices = ply.find("end_header\n") + 11;
    for (std::size_t v = 4; v > 0; --v) ply.insert(vertices + v * 12, 7, 'c');
    expect_tetrahedron("colours.ply", ply);
}

TEST_F(MeshInput, RefusesWhatCgalAloneWouldTakeForAMesh) {
    // Cut off, and shorter than the header of a binary file.
    EXPECT_THAT(error_of("a.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n"),
                HasSubstr("a.stl: expected facet or endsolid after line 6"));
    EXPECT_THAT(
        error_of("a.stl", replaced(as_stl_text(read_mesh(write("good.off", good_off))), " facet", " face")),
        HasSubstr("a.stl:2:2: expected facet, solid or endsolid, found \"face\""));
    EXPECT_THAT(error_of("a.obj", "v 0 0 0\nv 1 0 0\nf 0 1 2\nv 0 1 0\n"),
                HasSubstr("a.obj:3:3: expected a vertex number from 1"));
    EXPECT_THAT(error_of("a.off", replaced(good_off, "3 2 0 3", "3e9 2 0 3")),
                HasSubstr("a.off:10:1: expected a facet's number of corners, found \"3e9\""));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "float z", "float height")), HasSubstr("x, y and z"));
}

TEST_F(MeshInput, RefusesOtherFilesUnderItsExtensions) {
    std::string compressed = "\x1f\x8b\x08";
    for (int i = 0; i < 1000; ++i) compressed += static_cast<char>(i * i % 251);
    EXPECT_THAT(error_of("a.off", compressed), HasSubstr("a.off:1:1: expected the word OFF"));
    EXPECT_EQ(error_of("a.obj", compressed), "a.obj: expected triangles, found no facet");
    EXPECT_THAT(error_of("a.stl", compressed), HasSubstr("expected STL"));
    EXPECT_THAT(error_of("a.ply", compressed), HasSubstr("a.ply:1:1: expected the word ply"));
}

TEST_F(MeshInput, ReadsPly) {
    expect_tetrahedron("text.ply", good_ply);
    expect_tetrahedron("binary.ply", as_ply_binary(read_mesh(write("a.off", good_off))));
}

TEST_F(MeshInput, SaysWhatIsWrongWithTheFile) {
    EXPECT_EQ(error_of(folder_ / "none.off"), "none.off: there is no such file");
    fs::create_directory(folder_ / "folder.off");
    EXPECT_EQ(error_of(folder_ / "folder.off"), "folder.off: expected a mesh file, found a folder");
    EXPECT_EQ(error_of("a.step", "x"), "a.step: expected a mesh file ending in .off, .obj, .stl or .ply");
    EXPECT_EQ(error_of("empty.off", ""), "empty.off: the file is empty");
    EXPECT_EQ(error_of("points.obj", "v 0 0 0\n"), "points.obj: expected triangles, found no facet");
    EXPECT_EQ(error_of("none.off", "OFF\n0 0 0\n"), "none.off: expected triangles, found no facet");
}

TEST_F(MeshInput, SaysWhereAnOffIsWrong) {
    EXPECT_EQ(error_of("a.off", "off\n"), "a.off:1:1: expected the word OFF, found \"off\"");
    EXPECT_EQ(error_of("a.off", "OFF BINARY\n"),
              "a.off:1:5: expected the number of vertices, found \"BINARY\"");
    EXPECT_EQ(error_of("a.off", "OFF\n4 -4\n"), "a.off:2:3: expected the number of facets, found \"-4\"");
    EXPECT_THAT(
        error_of("a.off", replaced(good_off, "3 2 0 3\n", "# enough text in a comment")),
        HasSubstr("expected facet 4 of 4 after line 9, found the end of the file: it seems to be cut off"));
    EXPECT_THAT(error_of("a.off", good_off.substr(0, 41)),
                HasSubstr("expected facet 2 of 4 after line 7, found the end of the file"));
    EXPECT_EQ(error_of("a.off", replaced(good_off, "3 2 0 3", "3 2 0")),
              "a.off:10:6: expected a vertex number, found the end of the line");
    EXPECT_EQ(error_of("a.off", replaced(good_off, "3 2 0 3", "3 2 0 4")),
              "a.off:10:7: expected a vertex number from 0 to 3, found \"4\"");
    EXPECT_EQ(error_of("a.off", replaced(good_off, "3 2 0 3", "4 2 0 3 1")),
              "a.off:10:1: expected a triangle, found a facet with 4 corners: triangulate the mesh first");
    EXPECT_EQ(error_of("a.off", replaced(good_off, "0 1 0", "0 nan 0")),
              "a.off:5:3: expected coordinate y, a finite number, found \"nan\"");
}

TEST_F(MeshInput, DoesNotBelieveHugeCounts) {
    EXPECT_EQ(error_of("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"),
              "a.off: expected vertex 2 of 4000000000 after line 3, found the end of the file: it seems to "
              "be cut off");
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "face 4", "face 4000000000")),
                HasSubstr("expected 4000000000 facets, could read 4 vertices and 4 facets"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "uchar int", "int int")),
                HasSubstr("uchar as the type"));
    std::string stl = as_stl_binary(read_mesh(write("good.off", good_off)));
    stl[0] = 'S';
    stl.replace(80, 4, 4, '\xff');
    EXPECT_THAT(error_of("a.stl", stl), HasSubstr("found 284 bytes with 4294967295 facets promised"));
}

TEST_F(MeshInput, TakesNoMemoryForAHeaderThatPromisesTooMuch) {
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    EXPECT_THAT(error_of("a.off", "OFF\n1 20000000 0\n0 0 0\n"), HasSubstr("expected facet 1 of 20000000"));
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 100'000);  // kB
}

TEST_F(MeshInput, SaysWhereAnObjIsWrong) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    EXPECT_THAT(error_of("a.obj", vertices + "f 1 2 4 3\n"),
                HasSubstr("a.obj:5:9: expected a triangle, found a facet "
                          "with 4 corners: triangulate the mesh first"));
    EXPECT_THAT(error_of("a.obj", vertices + "f 1 2\n"), HasSubstr("a facet with 2 corners"));
    EXPECT_EQ(error_of("a.obj", vertices + "f 1 2 3\n\nf 1 2 5\n"),
              "a.obj:7:7: expected a vertex number from -4 to 4, found \"5\"");
    EXPECT_THAT(error_of("a.obj", vertices + "f 1 2 0\n"), HasSubstr("a.obj:5:7: expected a vertex number"));
    EXPECT_THAT(error_of("a.obj", vertices + "f 1 2 -5\n"), HasSubstr("a.obj:5:7: expected a vertex number"));
    EXPECT_EQ(error_of("a.obj", "v 0 NaN 0\n"),
              "a.obj:1:5: expected coordinate y, a finite number, found \"NaN\"");
}

TEST_F(MeshInput, SaysWhereAnStlIsWrong) {
    const SurfaceMesh mesh = read_mesh(write("good.off", good_off));
    const std::string text = as_stl_text(mesh);
    EXPECT_THAT(error_of("a.stl", text.substr(0, text.size() - 17)),
                HasSubstr("expected facet or endsolid after line"));
    EXPECT_THAT(error_of("a.stl", replaced(text, "vertex 0", "vertex inf")),
                HasSubstr("a.stl:4:11: expected coordinate x, a finite number, found \"inf\""));
    EXPECT_THAT(error_of("a.stl", replaced(text, "  endloop\n endfacet\n", "")),
                HasSubstr("a.stl:7:2: expected endloop"));
    const std::string binary = as_stl_binary(mesh);
    EXPECT_THAT(error_of("a.stl", replaced(binary.substr(0, binary.size() - 1), "solid", "Solid")),
                HasSubstr("found 283 bytes with 4 facets promised"));
    EXPECT_THAT(error_of("a.stl", binary + "x"), HasSubstr("found 285 bytes with 4 facets promised"));
    std::string strange = binary;
    strange.replace(84 + 50 + 12, 4, bytes(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_THAT(error_of("a.stl", strange),
                HasSubstr("facet 1 (counted from 0): expected finite coordinates"));
}

TEST_F(MeshInput, SaysWhatIsWrongWithAPly) {
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "ply", "plx")),
                HasSubstr("a.ply:1:1: expected the word ply"));
    EXPECT_THAT(error_of("a.ply", "ply\nformat ascii 1.0\n"), HasSubstr("expected end_header"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "float x", "int x")),
                HasSubstr("a.ply:5:14: expected coordinates"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "property float x\n", "")),
                HasSubstr("properties x, y and z"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "element vertex 4\n", "")),
                HasSubstr("an element before"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "comment", "element vertex 4\ncomment")),
                HasSubstr("each once"));
    EXPECT_THAT(error_of("a.ply", good_ply.substr(0, good_ply.size() - 8)),
                HasSubstr("expected 4 facets, could read 4 vertices and 3 facets: the file is cut off"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "3 2 0 3", "3 2 0 9")),
                HasSubstr("facet 3 (counted from 0): expected "
                          "vertex numbers from 0 to 3"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "3 2 0 3", "3 2 0 -9")), HasSubstr("found -9"));
    EXPECT_THAT(error_of("a.ply", replaced(good_ply, "3 2 0 3", "4 2 0 3 1")), HasSubstr("triangulate"));
    std::string binary = as_ply_binary(read_mesh(write("good.off", good_off)));
    EXPECT_THAT(error_of("a.ply", binary.substr(0, binary.size() - 1)),
                HasSubstr("expected 4 facets, could read 4 vertices and 3 facets"));
    binary.replace(binary.find("end_header\n") + 11, 4, bytes(std::numeric_limits<float>::infinity()));
    EXPECT_THAT(error_of("a.ply", binary), HasSubstr("finite"));
}

TEST_F(MeshInput, ScalesToASize) {
    SurfaceMesh mesh = read_mesh(write("a.off", replaced(good_off, "1 0 0", "4 0 0")));
    scale_to_size(mesh, 100);
    EXPECT_EQ(mesh.positions[1], Vec3(100, 0, 0));
    EXPECT_EQ(mesh.positions[2], Vec3(0, 25, 0));
    EXPECT_THROW(scale_to_size(mesh, 0), MeshError);
    EXPECT_THROW(scale_to_size(mesh, std::numeric_limits<double>::quiet_NaN()), MeshError);
    SurfaceMesh point{.positions = {{1, 2, 3}}, .facets = {}};
    EXPECT_THROW(scale_to_size(point, 100), MeshError);
}

TEST_F(MeshInput, OrganIsNamedAfterFileAndSize) {
    const fs::path file = write("liver.off", good_off);
    EXPECT_EQ(read_organ(file).organ.name, "liver");
    const OrganInput scaled = read_organ(file, 50);
    EXPECT_EQ(scaled.organ.name, "liver s50");
    EXPECT_EQ(scaled.organ.rest.positions[1], Vec3(50, 0, 0));
    EXPECT_TRUE(scaled.findings.empty());
}

TEST_F(MeshInput, OrganIsRefusedWithEverythingThatWasFound) {
    const fs::path file =
        write("broken.off", replaced(replaced(good_off, "3 2 0 3", "3 1 2 3"), "0 0 1", "0.5 0 0"));
    try {
        read_organ(file);
        FAIL() << "nothing was thrown";
    } catch (const MeshError& error) {
        EXPECT_THAT(error.what(), HasSubstr("broken.off: this mesh cannot be used"));
        EXPECT_THAT(error.what(), HasSubstr("\n  refused: facets without area: 1; facet 1"));
        EXPECT_THAT(error.what(),
                    HasSubstr("\n  refused: facets with the same vertices as another one: 1; facet 3"));
    }
}

}  // namespace
}  // namespace trocar
