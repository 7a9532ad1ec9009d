// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/read_mesh.h"

#include <gtest/gtest.h>

#include <cstring>

namespace ew {
namespace {

const char* const kPyramid = R"(# a pyramid
mtllib none.mtl
v 0 0 0
v 1 0 0
v 1.0 1e0 0
v 0 1 0
vt 0.5 0.5
vn 0 0 1
v 0.5 0.5 1
f 4 3 2 1
f 1/1 2/1 5/1
f 2//1 3//1 5//1
f -3 -2 -1
f 4 1 5
)";

const char* const kPly = R"(ply
format ascii 1.0
comment made by hand
element vertex 4
property float x
property float y
property float z
property uchar red
element face 4
property list uchar int vertex_indices
element edge 1
property int vertex1
property int vertex2
end_header
0 0 0 9
1 0 0 9
0 1 0 9
0 0 1 9
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
0 1
)";

TEST(ReadMesh, ReadsObj) {
    std::string text = kPyramid;
    text.replace(text.find("f -3 -2 -1"), 10, "f 3 -2 -1");
    const auto mesh = readMesh(text, "p.obj");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->vertices.size(), 5U);
    EXPECT_EQ(mesh->vertices[2], Vec3(1, 1, 0));
    EXPECT_EQ(mesh->faces, (std::vector<std::vector<int>>{
                               {3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
}

TEST(ReadMesh, ReadsPlyAsText) {
    const auto mesh = readMesh(kPly, "t.ply");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->vertices.size(), 4U);
    EXPECT_EQ(mesh->vertices[3], Vec3(0, 0, 1));
    EXPECT_EQ(mesh->faces[3], (std::vector<int>{1, 2, 3}));
}

TEST(ReadMesh, ReadsBinaryPly) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\n"
        "property double y\nproperty float z\nelement face 1\n"
        "property list uchar uint vertex_index\nend_header\n";
    for (const double x : {1.0, 2.0, 3.0}) {
        const float z = 0.5F;
        bytes.append(reinterpret_cast<const char*>(&x), 8);
        bytes.append(reinterpret_cast<const char*>(&x), 8);
        bytes.append(reinterpret_cast<const char*>(&z), 4);
    }
    bytes += '\3';
    for (const std::uint32_t v : {2U, 0U, 1U}) {
        bytes.append(reinterpret_cast<const char*>(&v), 4);
    }
    const auto mesh = readMesh(bytes, "b.ply");
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->vertices[2], Vec3(3, 3, 0.5));
    EXPECT_EQ(mesh->faces[0], (std::vector<int>{2, 0, 1}));
    // Cut anywhere it is an error, and no crash.
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        EXPECT_FALSE(readMesh(bytes.substr(0, n), "b.ply")) << n;
    }
}

TEST(ReadMesh, RefusesWhatIsNoMesh) {
    EXPECT_EQ(readMesh("", "x").error().code, Errc::WrongFormat);
    EXPECT_EQ(readMesh("solid cube", "x").error().code, Errc::WrongFormat);
    const auto bad = readMesh("v 0 0 0\nv 1 0\n", "x.obj");
    EXPECT_EQ(bad.error().code, Errc::Syntax);
    EXPECT_NE(bad.error().message.find("line 2"), std::string::npos) << bad.error().message;
    EXPECT_EQ(readMesh("v 0 0 nan\n", "x.obj").error().code, Errc::Syntax);
    EXPECT_EQ(readMesh("v 0 0 0\nf 0 1 1\n", "x.obj").error().code, Errc::Syntax);
    EXPECT_EQ(readMesh("v 0 0 0\nf 1 1\n", "x.obj").error().code, Errc::Syntax);
    std::string huge =
        "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\n"
        "element face 1\nproperty list uchar int vertex_index\nend_header\n";
    EXPECT_EQ(readMesh(huge, "x.ply").error().code, Errc::TooLarge);
    std::string many;
    for (int i = 0; i < 20'001; ++i) many += "v 0 0 0\n";
    EXPECT_EQ(readMesh(many, "x.obj").error().code, Errc::TooLarge);
}

}  // namespace
}  // namespace ew
