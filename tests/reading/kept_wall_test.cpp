// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/kept_wall.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

/// A box of 100 mm whose camera space is a rotation of its frame at 1 px a mm.
ModelView box() {
    OrthographicCamera camera = modificationCamera(0, Vec3(50, 50, 50));
    camera.worldPerPixel = 1.0;
    return *ModelView::make({solidOf(boxSpec(Vec3::Zero(), Vec3(100, 100, 100))), {}}, camera);
}

struct Tool {
    std::vector<std::vector<int>> faces;
    CameraPoints points;
};

/// Maps a point of the body to camera space, by three edges of the box.
Vec3 toCamera(const ModelView& model, const Vec3& p) {
    const auto& vertices = model.solid().vertices();
    const auto at = [&](const Vec3& corner) {
        const auto found = std::find_if(vertices.begin(), vertices.end(),
                                        [&](const Vec3& v) { return (v - corner).norm() < 1e-9; });
        return model.vertex(static_cast<int>(found - vertices.begin()));
    };
    const Vec3 o = at(Vec3::Zero());
    return o + p.x() / 100 * (at(Vec3(100, 0, 0)) - o) + p.y() / 100 * (at(Vec3(0, 100, 0)) - o) +
           p.z() / 100 * (at(Vec3(0, 0, 100)) - o);
}

Tool toolOf(const ModelView& model, const PolyhedronSpec& spec) {
    Tool tool{spec.faces, {}};
    for (const Vec3& v : spec.vertices) tool.points.push_back(toCamera(model, v));
    return tool;
}

int faceTowards(const ModelView& model, const Vec3& n) {
    const auto& faces = model.solid().faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (faces[f].normal.dot(n) > 0.999) return static_cast<int>(f);
    }
    return -1;
}

std::vector<int> all(const Tool& tool) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < tool.faces.size(); ++f) faces.push_back(static_cast<int>(f));
    return faces;
}

TEST(KeptWall, TheFaceThatHasToMoveLeastStaysClear) {
    const ModelView model = box();
    // Reaches 8 mm through the face at x = 100.
    Tool tool = toolOf(model, boxSpec(Vec3(40, 30, 30), Vec3(108, 70, 70)));
    const int met = faceTowards(model, Vec3::UnitX());
    const auto wall = wallClearOf(tool.faces, tool.points, all(tool), model, {met}, 5.0);
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->normal.dot(model.plane(met).normal), 1.0, 1e-9);
    EXPECT_NEAR(wall->offset, model.plane(met).offset - 5.0, 1e-9);
    ASSERT_TRUE(moveWall(*wall, tool.faces, tool.points));
    const Tool wanted = toolOf(model, boxSpec(Vec3(40, 30, 30), Vec3(95, 70, 70)));
    for (std::size_t v = 0; v < wanted.points.size(); ++v) {
        EXPECT_LT((tool.points[v] - wanted.points[v]).norm(), 1e-9);
    }
}

TEST(KeptWall, NothingWhereTooLittleWouldBeLeftOrNothingIsMet) {
    const ModelView model = box();
    const Tool tool = toolOf(model, boxSpec(Vec3(92, 30, 30), Vec3(108, 40, 40)));
    const int met = faceTowards(model, Vec3::UnitX());
    EXPECT_FALSE(wallClearOf(tool.faces, tool.points, all(tool), model, {met}, 5.0));
    const int other = faceTowards(model, Vec3::UnitY());
    EXPECT_FALSE(wallClearOf(tool.faces, tool.points, all(tool), model, {other}, 5.0));
    EXPECT_TRUE(wallClearOf(tool.faces, tool.points, all(tool), model, {met}, 3.0));
}

TEST(KeptWall, ACornerWithSeveralEdgesThatLeadThereDoesNotMove) {
    const ModelView model = box();
    // The apex of a pyramid over a square lies in each of its four sides.
    Tool tool;
    tool.faces = {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    for (const Vec3& v :
         {Vec3(0, 0, 0), Vec3(40, 0, 0), Vec3(40, 40, 0), Vec3(0, 40, 0), Vec3(20, 20, 30)}) {
        tool.points.push_back(v);
    }
    const CameraPoints before = tool.points;
    EXPECT_FALSE(moveWall({1, -Vec3::UnitY(), -5.0}, tool.faces, tool.points));
    for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(before[v], tool.points[v]);
    // Its base can.
    EXPECT_TRUE(moveWall({0, -Vec3::UnitZ(), -15.0}, tool.faces, tool.points));
    EXPECT_LT((tool.points[0] - Vec3(10, 10, 15)).norm(), 1e-9);
}

}  // namespace
}  // namespace ew::test
