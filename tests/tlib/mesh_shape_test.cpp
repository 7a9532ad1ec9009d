// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/mesh_shape.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/solid/solid.h"
#include "core/tlib/library.h"

namespace ew::test {
namespace {

PolyhedronSpec shipped(const std::string& id) {
    const auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
    return load->library.at(static_cast<std::size_t>(load->library.find(id))).shape;
}

/// Every triangle with points of its own, as an STL file has them.
PolyhedronSpec loose(const PolyhedronSpec& shape) {
    const Solid solid = *Solid::fromSpec(shape);
    PolyhedronSpec mesh;
    for (const SolidTriangle& t : solid.triangles()) {
        std::vector<int> face;
        for (const int v : t.vertices) {
            face.push_back(static_cast<int>(mesh.vertices.size()));
            mesh.vertices.push_back(solid.vertices()[static_cast<std::size_t>(v)]);
        }
        mesh.faces.push_back(std::move(face));
    }
    return mesh;
}

/// A square ring: a box with a square hole through it.
PolyhedronSpec ring() {
    PolyhedronSpec mesh;
    for (const double z : {0.0, 1.0}) {
        for (const double r : {3.0, 1.0}) {
            mesh.vertices.insert(mesh.vertices.end(),
                                 {{-r, -r, z}, {r, -r, z}, {r, r, z}, {-r, r, z}});
        }
    }
    for (int i = 0; i < 4; ++i) {
        const int k = (i + 1) % 4;
        mesh.faces.push_back({i, k, 8 + k, 8 + i});            // outside
        mesh.faces.push_back({4 + k, 4 + i, 12 + i, 12 + k});  // inside
        mesh.faces.push_back({k, i, 4 + i, 4 + k});            // bottom
        mesh.faces.push_back({8 + i, 8 + k, 12 + k, 12 + i});  // top
    }
    return mesh;
}

TEST(MeshShape, LooseTrianglesAreTheShapeThatTheyWereCutFrom) {
    for (const char* id : {"cube", "l-prism", "triangular-prism", "wedge-frustum"}) {
        const PolyhedronSpec shape = shipped(id);
        const auto found = shapeOfMesh(loose(shape));
        ASSERT_TRUE(found) << id << ": " << found.error().message;
        EXPECT_EQ(found->vertices.size(), shape.vertices.size()) << id;
        EXPECT_EQ(found->faces.size(), shape.faces.size()) << id;
        EXPECT_NEAR(Solid::fromSpec(*found)->volume(), Solid::fromSpec(shape)->volume(), 1e-9);
    }
}

TEST(MeshShape, PointsInsideStraightEdgesGo) {
    PolyhedronSpec box = shipped("cube");
    // A point in the middle of the first edge of the first face, in both of its faces.
    const int a = box.faces[0][0];
    const int b = box.faces[0][1];
    const int middle = static_cast<int>(box.vertices.size());
    box.vertices.push_back(
        (box.vertices[static_cast<std::size_t>(a)] + box.vertices[static_cast<std::size_t>(b)]) /
        2.0);
    for (std::vector<int>& face : box.faces) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int from = face[i];
            const int to = face[(i + 1) % face.size()];
            if (std::minmax(from, to) != std::minmax(a, b)) continue;
            face.insert(face.begin() + static_cast<std::ptrdiff_t>(i + 1), middle);
            break;
        }
    }
    const auto found = shapeOfMesh(box);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->vertices.size(), 8U);
}

TEST(MeshShape, RefusesWhatIsNoShape) {
    PolyhedronSpec open = shipped("cube");
    open.faces.pop_back();
    EXPECT_EQ(shapeOfMesh(open).error().message, "The mesh is not closed.");
    EXPECT_NE(shapeOfMesh(ring()).error().message.find("holes"), std::string::npos);
    PolyhedronSpec turned = shipped("cube");
    std::reverse(turned.faces[0].begin(), turned.faces[0].end());
    EXPECT_EQ(shapeOfMesh(turned).error().code, Errc::BadTemplate);
    PolyhedronSpec lost = shipped("cube");
    lost.faces[0][0] = 99;
    EXPECT_EQ(shapeOfMesh(lost).error().code, Errc::BadValue);
    lost.faces[0][0] = -1;
    EXPECT_EQ(shapeOfMesh(lost).error().code, Errc::BadValue);
    EXPECT_EQ(shapeOfMesh({}).error().code, Errc::BadTemplate);
    PolyhedronSpec nowhere = shipped("cube");
    nowhere.vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(shapeOfMesh(nowhere).error().code, Errc::BadValue);
    PolyhedronSpec many;
    many.vertices.resize(kMaxMeshPoints + 1, Vec3::Zero());
    EXPECT_EQ(shapeOfMesh(many).error().code, Errc::BadTemplate);
}

}  // namespace
}  // namespace ew::test
