// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace ew::test {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with the test.
class ExportMesh : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  ("ew-export-" + std::string(info->name()) + "-" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t fileCount() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    fs::path folder_;
};

PolyhedronSpec boxSpec(const Vec3& size) {
    PolyhedronSpec spec;
    for (const double z : {0.0, size.z()}) {
        spec.vertices.emplace_back(0, 0, z);
        spec.vertices.emplace_back(size.x(), 0, z);
        spec.vertices.emplace_back(size.x(), size.y(), z);
        spec.vertices.emplace_back(0, size.y(), z);
    }
    spec.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return spec;
}

/// A block of 4 x 4 x 1 with a square hole of 2 x 2 through it: two faces with a hole.
PolyhedronSpec ringSpec() {
    PolyhedronSpec spec;
    for (const double z : {0.0, 1.0}) {
        for (const double r : {2.0, 1.0}) {
            for (const Vec2& p : {Vec2(-r, -r), Vec2(r, -r), Vec2(r, r), Vec2(-r, r)}) {
                spec.vertices.emplace_back(p.x(), p.y(), z);
            }
        }
    }
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        spec.faces.push_back({8 + i, 8 + j, 12 + j, 12 + i});
        spec.faces.push_back({j, i, 4 + i, 4 + j});
        spec.faces.push_back({i, j, 8 + j, 8 + i});
        spec.faces.push_back({4 + j, 4 + i, 12 + i, 12 + j});
    }
    return spec;
}

Body body(const PolyhedronSpec& spec, const Pose& pose = {}) {
    auto solid = Solid::fromSpec(spec);
    EXPECT_TRUE(solid) << solid.error().message;
    return {*solid, pose};
}

Pose somePose() {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    pose.translation = Vec3(10, -20, 30);
    return pose;
}

std::string bytesOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream out;
    out << in.rdbuf();
    return out.str();
}

struct Read {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;
    int objects = 0;
};

Read readObj(const std::string& path) {
    Read out;
    std::istringstream in(bytesOf(path));
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        if (key == "o") ++out.objects;
        if (key == "v") {
            Vec3 p;
            words >> p.x() >> p.y() >> p.z();
            out.points.push_back(p);
        }
        if (key == "f") {
            out.faces.emplace_back();
            for (int i = 0; words >> i;) out.faces.back().push_back(i - 1);
        }
    }
    return out;
}

template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value{};
    EXPECT_LE(at + sizeof(T), bytes.size());
    if (at + sizeof(T) <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof(T));
    at += sizeof(T);
    return value;
}

Read readStl(const std::string& path) {
    const std::string bytes = bytesOf(path);
    Read out;
    std::size_t at = 80;
    const auto count = take<std::uint32_t>(bytes, at);
    EXPECT_EQ(bytes.size(), 84U + 50U * count);
    for (std::uint32_t t = 0; t < count; ++t) {
        Vec3 normal;
        for (int k = 0; k < 3; ++k) normal[k] = take<float>(bytes, at);
        out.faces.emplace_back();
        for (int corner = 0; corner < 3; ++corner) {
            Vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = take<float>(bytes, at);
            out.faces.back().push_back(static_cast<int>(out.points.size()));
            out.points.push_back(p);
        }
        const Vec3* p = &out.points[out.points.size() - 3];
        // The corners are rounded to single precision, which turns a triangle the more the thinner
        // it is.
        const Vec3 cross = (p[1] - p[0]).cross(p[2] - p[0]);
        const double longest =
            std::max({(p[1] - p[0]).norm(), (p[2] - p[0]).norm(), (p[2] - p[1]).norm()});
        const double largest = std::max({p[0].norm(), p[1].norm(), p[2].norm()});
        const double turn = 4e-7 * largest * longest / cross.norm();
        EXPECT_LT((normal - cross.normalized()).norm(), 1e-6 + turn);
        EXPECT_EQ(take<std::uint16_t>(bytes, at), 0);
    }
    return out;
}

Read readPly(const std::string& path) {
    const std::string bytes = bytesOf(path);
    const std::string end = "end_header\n";
    const auto headerEnd = bytes.find(end);
    EXPECT_NE(headerEnd, std::string::npos);
    std::istringstream header(bytes.substr(0, headerEnd));
    std::map<std::string, std::size_t> counts;
    std::string word;
    while (header >> word) {
        if (word == "element") {
            header >> word;
            header >> counts[word];
        }
    }
    Read out;
    std::size_t at = headerEnd + end.size();
    for (std::size_t i = 0; i < counts["vertex"]; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = take<double>(bytes, at);
        out.points.push_back(p);
    }
    for (std::size_t i = 0; i < counts["face"]; ++i) {
        const int n = take<std::uint8_t>(bytes, at);
        out.faces.emplace_back();
        for (int k = 0; k < n; ++k) out.faces.back().push_back(take<std::int32_t>(bytes, at));
    }
    EXPECT_EQ(at, bytes.size());
    return out;
}

double volumeOf(const Read& mesh) {
    double six = 0.0;
    const Vec3 o = mesh.points[0];
    const auto at = [&](int i) -> Vec3 { return mesh.points[static_cast<std::size_t>(i)] - o; };
    for (const auto& face : mesh.faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            six += at(face[0]).dot(at(face[k]).cross(at(face[k + 1])));
        }
    }
    return six / 6.0;
}

/// Every polygon is free of repeated points and every edge has its opposite.
void expectClosed(const Read& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& face : mesh.faces) {
        EXPECT_EQ(std::set<int>(face.begin(), face.end()).size(), face.size());
        for (std::size_t k = 0; k < face.size(); ++k) {
            ++edges[{face[k], face[(k + 1) % face.size()]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

TEST_F(ExportMesh, ObjHasThePlanarFaces) {
    const std::string file = path("box.obj");
    ASSERT_TRUE(exportBodies({body(boxSpec(Vec3(3, 2, 1)))}, file));
    const Read mesh = readObj(file);
    EXPECT_EQ(mesh.points.size(), 8U);
    EXPECT_EQ(mesh.faces.size(), 6U);
    EXPECT_EQ(mesh.objects, 1);
    for (const auto& face : mesh.faces) EXPECT_EQ(face.size(), 4U);
    expectClosed(mesh);
    EXPECT_NEAR(volumeOf(mesh), 6.0, 1e-14);
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(ExportMesh, ObjKeepsEveryDigit) {
    const std::string file = path("thirds.obj");
    const Body thirds = body(boxSpec(Vec3(1.0 / 3.0, 0.1, 1e-5)), somePose());
    ASSERT_TRUE(exportBodies({thirds}, file));
    const Read mesh = readObj(file);
    ASSERT_EQ(mesh.points.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(mesh.points[i], thirds.pose.toWorld(thirds.solid.vertices()[i]));
    }
}

TEST_F(ExportMesh, StlHasTrianglesAndNormals) {
    const std::string file = path("box.STL");
    ASSERT_TRUE(exportBodies({body(boxSpec(Vec3(3, 2, 1)))}, file));
    const Read mesh = readStl(file);
    EXPECT_EQ(mesh.faces.size(), 12U);
    EXPECT_NEAR(volumeOf(mesh), 6.0, 1e-5);
}

TEST_F(ExportMesh, PlyHasThePlanarFaces) {
    const std::string file = path("box.ply");
    ASSERT_TRUE(exportBodies({body(boxSpec(Vec3(3, 2, 1)))}, file));
    const Read mesh = readPly(file);
    EXPECT_EQ(mesh.points.size(), 8U);
    EXPECT_EQ(mesh.faces.size(), 6U);
    expectClosed(mesh);
    EXPECT_NEAR(volumeOf(mesh), 6.0, 1e-14);
}

TEST_F(ExportMesh, FacesWithHolesBecomeFewSimplePolygons) {
    const Body ring = body(ringSpec());
    ASSERT_EQ(ring.solid.faces().size(), 10U);
    const auto polygons = facePolygons(ring.solid);
    EXPECT_EQ(polygons.size(), 12U);  // a ring takes two
    ASSERT_TRUE(exportBodies({ring}, path("ring.obj"), ExportFaces::Polygons));
    ASSERT_TRUE(exportBodies({ring}, path("ring.ply"), ExportFaces::Polygons));
    for (const Read& mesh : {readObj(path("ring.obj")), readPly(path("ring.ply"))}) {
        EXPECT_EQ(mesh.faces.size(), 12U);
        expectClosed(mesh);
        EXPECT_NEAR(volumeOf(mesh), 12.0, 1e-13);
    }
}

/// An L in the plane z = 0, extruded: two faces of six corners, one of them concave, and a kite of
/// four corners as its foot.
PolyhedronSpec bracketSpec() {
    PolyhedronSpec spec;
    const std::vector<Vec2> outline{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const int n = static_cast<int>(outline.size());
    for (const double z : {0.0, 2.0}) {
        for (const Vec2& p : outline) spec.vertices.emplace_back(p.x(), p.y(), z);
    }
    spec.faces.resize(2);
    for (int i = 0; i < n; ++i) {
        spec.faces[0].insert(spec.faces[0].begin(), i);
        spec.faces[1].push_back(n + i);
        const int j = (i + 1) % n;
        spec.faces.push_back({i, j, n + j, n + i});
    }
    return spec;
}

/// An arrowhead, whose four corners are no convex polygon, extruded.
PolyhedronSpec arrowSpec() {
    PolyhedronSpec spec;
    const std::vector<Vec2> outline{{0, 0}, {4, -3}, {1, 0}, {4, 3}};
    for (const double z : {0.0, 2.0}) {
        for (const Vec2& p : outline) spec.vertices.emplace_back(p.x(), p.y(), z);
    }
    spec.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return spec;
}

TEST_F(ExportMesh, CommonReadersTakeTheFaces) {
    struct Case {
        PolyhedronSpec spec;
        std::size_t simple, triangles, polygons;
    };
    const std::vector<Case> cases{{boxSpec(Vec3(3, 2, 1)), 6, 12, 6},
                                  {bracketSpec(), 6 + 8, 12 + 8, 8},
                                  {arrowSpec(), 4 + 4, 8 + 4, 6},
                                  {ringSpec(), 8 + 16, 16 + 16, 12}};
    for (const Case& c : cases) {
        const Body one = body(c.spec);
        for (const char* name : {"f.obj", "f.ply"}) {
            const auto counted = [&](ExportFaces faces) {
                EXPECT_TRUE(exportBodies({one}, path(name), faces));
                const Read mesh = name[2] == 'o' ? readObj(path(name)) : readPly(path(name));
                expectClosed(mesh);
                EXPECT_NEAR(volumeOf(mesh), one.solid.volume(), 1e-9);
                return mesh;
            };
            const Read simple = counted(ExportFaces::Simple);
            EXPECT_EQ(simple.faces.size(), c.simple) << name;
            for (const auto& face : simple.faces) EXPECT_LE(face.size(), 4U);
            const Read triangles = counted(ExportFaces::Triangles);
            EXPECT_EQ(triangles.faces.size(), c.triangles) << name;
            for (const auto& face : triangles.faces) EXPECT_EQ(face.size(), 3U);
            EXPECT_EQ(counted(ExportFaces::Polygons).faces.size(), c.polygons) << name;
        }
    }
}

/// Triangles of which two corners are one, or whose corners are in a line.
int degenerate(const Read& mesh) {
    int count = 0;
    for (const auto& f : mesh.faces) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return mesh.points[static_cast<std::size_t>(f[k])];
        };
        count += (at(1) - at(0)).cross(at(2) - at(0)).norm() > 0.0 ? 0 : 1;
    }
    return count;
}

TEST_F(ExportMesh, FarFromTheOriginTheFileHasAnOriginOfItsOwn) {
    Body far = body(boxSpec(Vec3(30, 20, 10)), somePose());
    far.pose.translation = Vec3(1e9, -2e9, 0.5);
    const auto stl = exportBodies({far}, path("far.stl"));
    ASSERT_TRUE(stl) << stl.error().message;
    EXPECT_EQ(*stl, "It lies far out: in the file, the origin is at 1000000010 -1999999990 20 mm.");
    EXPECT_EQ(bytesOf(path("far.stl")).find("Edgewright, mm, origin at 1000000010 -1999999990 20 "),
              0U);
    const Read mesh = readStl(path("far.stl"));
    EXPECT_EQ(degenerate(mesh), 0);
    EXPECT_NEAR(volumeOf(mesh), 6000.0, 1e-2);
    const auto ply = exportBodies({far}, path("far.ply"));
    ASSERT_TRUE(ply);
    EXPECT_EQ(*ply, *stl);
    EXPECT_NE(bytesOf(path("far.ply")).find("\ncomment origin at 1000000010 -1999999990 20\n"),
              std::string::npos);
    Read moved = readPly(path("far.ply"));
    for (const Vec3& p : moved.points) EXPECT_LT(p.norm(), 50.0);
    const auto obj = exportBodies({far}, path("far.obj"));
    ASSERT_TRUE(obj);
    EXPECT_EQ(*obj, "");
    EXPECT_EQ(readObj(path("far.obj")).points[0], far.pose.toWorld(far.solid.vertices()[0]));
    // Near by its own size, nothing is moved.
    const auto near = exportBodies({body(boxSpec(Vec3(3, 2, 1)), somePose())}, path("near.stl"));
    ASSERT_TRUE(near);
    EXPECT_EQ(*near, "");
    EXPECT_EQ(bytesOf(path("near.stl")).find("origin"), std::string::npos);
}

TEST_F(ExportMesh, WhatAFormatCannotHoldIsRefused) {
    Body far = body(boxSpec(Vec3(30, 20, 10)));
    far.pose.translation.x() = 1e9;
    const std::vector<Body> apart{far, body(boxSpec(Vec3(30, 20, 10)))};
    const auto stl = exportBodies(apart, path("apart.stl"));
    ASSERT_FALSE(stl);
    EXPECT_EQ(stl.error().code, Errc::BadValue);
    EXPECT_EQ(fileCount(), 0U);
    for (const char* name : {"apart.glb", "apart.3mf", "apart.ply", "apart.obj"}) {
        EXPECT_TRUE(exportBodies(apart, path(name))) << name;
    }
    Body lost = body(boxSpec(Vec3(30, 20, 10)));
    lost.pose.translation.x() = 1e15;
    for (const char* name : {"lost.stl", "lost.obj"}) {
        const auto refused = exportBodies({lost}, path(name));
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().code, Errc::BadValue);
    }
}

TEST_F(ExportMesh, SeveralBodiesInTheWorld) {
    const std::vector<Body> bodies{body(boxSpec(Vec3(3, 2, 1))), body(ringSpec(), somePose())};
    for (const char* name : {"two.obj", "two.ply", "two.stl"}) {
        ASSERT_TRUE(exportBodies(bodies, path(name)));
    }
    const Read obj = readObj(path("two.obj"));
    EXPECT_EQ(obj.objects, 2);
    EXPECT_EQ(obj.points.size(), 24U);
    expectClosed(obj);
    EXPECT_NEAR(volumeOf(obj), 18.0, 1e-10);
    EXPECT_NEAR(volumeOf(readPly(path("two.ply"))), 18.0, 1e-10);
    EXPECT_NEAR(volumeOf(readStl(path("two.stl"))), 18.0, 1e-3);
    EXPECT_LT((obj.points[8] - somePose().toWorld(Vec3(-2, -2, 0))).norm(), 1e-13);
}

TEST_F(ExportMesh, OverwritesWholeFilesOnly) {
    const std::string file = path("box.obj");
    ASSERT_TRUE(exportBodies({body(ringSpec())}, file));
    ASSERT_TRUE(exportBodies({body(boxSpec(Vec3(1, 1, 1)))}, file));
    EXPECT_EQ(readObj(file).faces.size(), 6U);
    const std::string before = bytesOf(file);
    EXPECT_FALSE(exportBodies({}, file));
    EXPECT_EQ(bytesOf(file), before);
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(ExportMesh, RefusalsHaveTheirCode) {
    const Body cube = body(boxSpec(Vec3(1, 1, 1)));
    Body lost = cube;
    lost.pose.translation.x() = std::numeric_limits<double>::quiet_NaN();
    Body far = cube;
    far.pose.translation.x() = 1e300;
    fs::create_directories(folder_ / "folder.obj");
    std::ofstream(folder_ / "file") << "x";
    struct Case {
        std::vector<Body> bodies;
        std::string path;
        Errc code;
    };
    const std::vector<Case> cases{
        {{}, path("a.obj"), Errc::NoSolid},
        {{cube}, path("a.step"), Errc::UnknownExtension},
        {{cube}, path("a"), Errc::UnknownExtension},
        {{cube}, "", Errc::UnknownExtension},
        {{cube}, path(".obj"), Errc::UnknownExtension},
        {{cube}, path("nowhere/a.obj"), Errc::CannotWrite},
        {{cube}, path("file/a.obj"), Errc::CannotWrite},
        {{cube}, path("folder.obj"), Errc::CannotWrite},
        {{cube}, path(std::string(400, 'a') + ".obj"), Errc::CannotWrite},
        {{cube}, "/proc/a.obj", Errc::CannotWrite},
        {{lost}, path("a.obj"), Errc::BadValue},
        {{far}, path("a.stl"), Errc::BadValue},
    };
    for (const Case& c : cases) {
        const auto ok = exportBodies(c.bodies, c.path);
        ASSERT_FALSE(ok) << c.path;
        EXPECT_EQ(errcName(ok.error().code), errcName(c.code)) << ok.error().message;
        EXPECT_EQ(ok.error().message.back(), '.');
    }
    EXPECT_EQ(fileCount(), 2U);  // nothing was left behind
}

TEST_F(ExportMesh, NamesMayHoldAnyLetters) {
    ASSERT_TRUE(
        exportBodies({body(boxSpec(Vec3(1, 1, 1)))}, path("W\xc3\xbcrfel \xe7\xab\x8b.obj")));
    EXPECT_EQ(readObj(path("W\xc3\xbcrfel \xe7\xab\x8b.obj")).faces.size(), 6U);
}

RC_GTEST_FIXTURE_PROP(ExportMesh, EveryFormatHasTheVolume, ()) {
    const auto length = [] { return *rc::gen::inRange(1, 4000) * 0.025; };
    const Vec3 size(length(), length(), length());
    const Body one = body(boxSpec(size), somePose());
    for (const char* name : {"v.obj", "v.ply", "v.stl"})
        RC_ASSERT(exportBodies({one}, path(name)).has_value());
    const double volume = size.prod();
    RC_ASSERT(std::abs(volumeOf(readObj(path("v.obj"))) - volume) < 1e-9 * volume);
    RC_ASSERT(std::abs(volumeOf(readPly(path("v.ply"))) - volume) < 1e-9 * volume);
    // Single precision 40 mm from the origin: 2e-6 mm a coordinate, against the thinnest side.
    RC_ASSERT(std::abs(volumeOf(readStl(path("v.stl"))) - volume) < 1e-3 * volume);
}

}  // namespace
}  // namespace ew::test
