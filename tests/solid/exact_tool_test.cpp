// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/exact_tool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/solid/boolean.h"
#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

/// A box that was turned in doubles: none of its planes is a round number.
Solid turnedBox() {
    return *Solid::fromSpec(moved(box(Vec3(0, 0, 0), Vec3(4, 3, 2)), 0.7, 10.0, Vec3(3, -5, 7)));
}

/// The face whose normal is nearest to a direction of the box before it was turned.
int faceTowards(const Solid& solid, const Vec3& direction) {
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    int best = 0;
    for (std::size_t f = 1; f < solid.faces().size(); ++f) {
        const auto toward = [&](std::size_t g) {
            return solid.faces()[g].normal.dot(turn * direction);
        };
        if (toward(f) > toward(static_cast<std::size_t>(best))) best = static_cast<int>(f);
    }
    return best;
}

/// The same motion as turnedBox's, in doubles.
PolyhedronSpec turned(const PolyhedronSpec& spec) { return moved(spec, 0.7, 10.0, Vec3(3, -5, 7)); }

Solid need(const Result<Solid>& result) {
    EXPECT_TRUE(result) << errcName(result.error().code) << " " << result.error().message;
    return result ? *result : turnedBox();
}

void expectCounts(const Solid& s, std::size_t vertices, std::size_t edges, std::size_t faces) {
    EXPECT_EQ(s.vertices().size(), vertices);
    EXPECT_EQ(s.edges().size(), edges);
    EXPECT_EQ(s.faces().size(), faces);
    EXPECT_EQ(s.shellCount(), 1);
}

TEST(ExactTool, ABossStandsInThePlaneOfATurnedFace) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape = turned(box(Vec3(1, 1, 2), Vec3(2, 2, 3)));
    spec.faces = {{0, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())}};
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 16, 24, 11);
    EXPECT_NEAR(out->solid.volume(), 25000.0, 1e-6);
}

TEST(ExactTool, AWallRunsAcrossAnEdgeOfItsFace) {
    const Solid target = turnedBox();
    const int top = faceTowards(target, Vec3::UnitZ());
    int edge = -1;
    for (std::size_t e = 0; e < target.edges().size(); ++e) {
        const auto& faces = target.edges()[e].faces;
        if (faces[0] == top || faces[1] == top) edge = static_cast<int>(e);
    }
    const auto& ends = target.edges()[static_cast<std::size_t>(edge)].ends;
    const Vec3 along = (target.vertices()[static_cast<std::size_t>(ends[1])] -
                        target.vertices()[static_cast<std::size_t>(ends[0])])
                           .normalized();
    const Vec3 normal = target.faces()[static_cast<std::size_t>(top)].normal;
    ToolSpec spec;
    spec.shape = turned(box(Vec3(1, 1, 2), Vec3(2, 2, 3)));
    spec.faces = {{0, ToolFaceRule::Kind::InFace, top}};
    // The sides that cross the edge lean a little before they are told not to.
    std::array<int, 2> side{};
    for (const auto& loop : spec.shape.faces) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 d = (spec.shape.vertices[static_cast<std::size_t>(loop[(k + 1) % 4])] -
                            spec.shape.vertices[static_cast<std::size_t>(loop[k])])
                               .normalized();
            if (std::abs(d.dot(normal.cross(along))) > 0.999) side = {loop[k], loop[(k + 1) % 4]};
        }
    }
    spec.shape.vertices[static_cast<std::size_t>(side[0])] += 1e-9 * along;
    spec.edges = {{side, ToolEdgeRule::Kind::AcrossEdge, edge, top}};
    const Solid tool = need(makeTool(target, spec));
    const Vec3 made = (tool.vertices()[static_cast<std::size_t>(side[1])] -
                       tool.vertices()[static_cast<std::size_t>(side[0])])
                          .normalized();
    EXPECT_LT(std::abs(made.dot(along)), 1e-14);
    EXPECT_LT(std::abs(made.dot(normal)), 1e-14);

    spec.edges.front().other = 99;
    EXPECT_EQ(makeTool(target, spec).error().code, Errc::BadValue);
}

TEST(ExactTool, WithoutARuleATurnedBossIsASliver) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape = turned(box(Vec3(1, 1, 2 + 1e-12), Vec3(2, 2, 3)));
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_FALSE(out);
    EXPECT_EQ(errcName(out.error().code), "sliver");
}

TEST(ExactTool, SnapFindsTheRules) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.snap = true;
    spec.shape = turned(box(Vec3(4, 0, 0), Vec3(5, 3, 2)));  // makes the box longer
    for (Vec3& p : spec.shape.vertices) p += Vec3(1e-9, -1e-9, 2e-9);
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 8, 12, 6);
    spec.shape = turned(box(Vec3(1, 0, 2), Vec3(2, 3, 3)));  // a bar across the top, flush twice
    const auto bar = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_TRUE(bar) << bar.error().message;
    expectCounts(bar->solid, 16, 24, 10);
    spec.shape = turned(box(Vec3(1, 1, 0), Vec3(2, 2, 2)));  // a bore through both faces
    const auto bore = combine(target, need(makeTool(target, spec)), BooleanKind::Cut);
    ASSERT_TRUE(bore) << bore.error().message;
    expectCounts(bore->solid, 16, 24, 10);
    EXPECT_EQ(bore->solid.genus(), 1);
}

/// A corner cut off by a tetrahedron whose three faces lie in faces of the box.
TEST(ExactTool, ACornerIsCutOff) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    spec.shape.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    spec.shape = turned(spec.shape);
    spec.faces = {
        {0, ToolFaceRule::Kind::InFace, faceTowards(target, -Vec3::UnitZ())},
        {1, ToolFaceRule::Kind::InFace, faceTowards(target, -Vec3::UnitY())},
        {2, ToolFaceRule::Kind::InFace, faceTowards(target, -Vec3::UnitX())},
    };
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Cut);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 10, 15, 7);
    EXPECT_NEAR(out->solid.volume(), 24000.0 - 1000.0 / 6.0, 1e-6);
}

/// The vertex of the target nearest to a place of the box before it was turned.
int vertexAt(const Solid& solid, const Vec3& place) {
    PolyhedronSpec one;
    one.vertices = {place};
    const Vec3 p = turned(one).vertices[0];
    const auto& all = solid.vertices();
    return static_cast<int>(std::min_element(all.begin(), all.end(),
                                             [&](const Vec3& a, const Vec3& b) {
                                                 return (a - p).norm() < (b - p).norm();
                                             }) -
                            all.begin());
}

/// A cut through three corners of the box exactly: the corner's faces become triangles.
TEST(ExactTool, AThroughCutEndsInCorners) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {0, 0, 2}};
    spec.shape.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    spec.shape = turned(spec.shape);
    for (const int v : {0, 1, 2, 3}) {
        const std::array<Vec3, 4> at{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 2)};
        spec.vertices.push_back({v, ToolVertexRule::Kind::AtVertex,
                                 vertexAt(target, at[static_cast<std::size_t>(v)]), -1, 0.0});
    }
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Cut);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 7, 12, 7);
    EXPECT_NEAR(out->solid.volume(), 20000.0, 1e-6);
}

int edgeBetween(const Solid& solid, int a, int b) {
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        if (ends == std::array{a, b} || ends == std::array{b, a}) return static_cast<int>(e);
    }
    return -1;
}

/// Half of an edge chamfered: the prism's edge lies on the box's, its near end is a corner, its
/// far end the middle of the edge.
TEST(ExactTool, AChamferOfHalfAnEdge) {
    const Solid target = turnedBox();
    const int a = vertexAt(target, Vec3(0, 0, 2));
    const int b = vertexAt(target, Vec3(4, 0, 2));
    const int edge = edgeBetween(target, a, b);
    ASSERT_GE(edge, 0);
    ToolSpec spec;
    spec.shape.vertices = {{0, 0, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 2}, {2, 1, 2}, {2, 0, 1}};
    spec.shape.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {0, 2, 5, 3}, {1, 4, 5, 2}};
    if (plainVolume(spec.shape) < 0) spec.shape = insideOut(spec.shape);
    spec.shape = turned(spec.shape);
    spec.vertices = {{0, ToolVertexRule::Kind::AtVertex, a, -1, 0.0},
                     {3, ToolVertexRule::Kind::BetweenVertices, a, b, 0.5}};
    spec.faces = {{0, ToolFaceRule::Kind::InFace, faceTowards(target, -Vec3::UnitX())},
                  {1, ToolFaceRule::Kind::NormalToEdge, edge},
                  {2, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())},
                  {3, ToolFaceRule::Kind::InFace, faceTowards(target, -Vec3::UnitY())},
                  {4, ToolFaceRule::Kind::AlongEdge, edge}};
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Cut);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 12, 18, 8);
    EXPECT_NEAR(out->solid.volume(), 24000.0 - 1000.0, 1e-6);
}

/// A pyramid over a whole face: its base corners are the box's, its apex free.
TEST(ExactTool, APyramidOverAWholeFace) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape.vertices = {{0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 3, 2}, {2, 1, 4}};
    spec.shape.faces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const std::vector<Vec3> base(spec.shape.vertices.begin(), spec.shape.vertices.begin() + 4);
    spec.shape = turned(spec.shape);
    for (std::size_t v = 0; v < 4; ++v) {
        spec.vertices.push_back({static_cast<int>(v), ToolVertexRule::Kind::AtVertex,
                                 vertexAt(target, base[v]), -1, 0.0});
    }
    spec.faces = {{0, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())}};
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_TRUE(out) << out.error().message;
    expectCounts(out->solid, 9, 16, 9);
}

/// A box that stands free on a face, turned in it: two corners on an edge of the face, uprights
/// along the normal.
TEST(ExactTool, CornersOnAnEdgeAndUprightsAlongTheNormal) {
    const Solid target = turnedBox();
    const int top = faceTowards(target, Vec3::UnitZ());
    const int edge =
        edgeBetween(target, vertexAt(target, Vec3(0, 0, 2)), vertexAt(target, Vec3(4, 0, 2)));
    ToolSpec spec;
    spec.shape = turned(box(Vec3(1, 0, 2), Vec3(2, 1, 3)));
    spec.vertices = {{0, ToolVertexRule::Kind::OnEdge, edge, -1, 0.0},
                     {1, ToolVertexRule::Kind::OnEdge, edge, -1, 0.0}};
    spec.faces = {{0, ToolFaceRule::Kind::InFace, top}};
    for (int v = 0; v < 4; ++v) {
        spec.edges.push_back({{v, v + 4}, ToolEdgeRule::Kind::AlongNormal, top});
    }
    // The turned box's faces are perpendicular to rounding only, so uprights along the normal miss
    // its front by less than a hair: that is told, not glued.
    const auto hair = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_FALSE(hair);
    EXPECT_EQ(hair.error().code, Errc::Sliver);

    // Asked to lie in the front it does, exactly.
    spec.edges.clear();
    for (std::size_t f = 0; f < spec.shape.faces.size(); ++f) {
        const auto& loop = spec.shape.faces[f];
        const auto has = [&](int v) {
            return std::find(loop.begin(), loop.end(), v) != loop.end();
        };
        if (has(0) && has(1) && has(4)) {
            spec.faces.push_back({static_cast<int>(f), ToolFaceRule::Kind::InFace,
                                  faceTowards(target, -Vec3::UnitY())});
        }
    }
    ASSERT_EQ(spec.faces.size(), 2u);
    const auto out = combine(target, need(makeTool(target, spec)), BooleanKind::Add);
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->solid.shellCount(), 1);
    EXPECT_NEAR(out->solid.volume(), 25000.0, 1e-3);
}

TEST(ExactTool, ContradictionsAreNamed) {
    const Solid target = turnedBox();
    ToolSpec spec;
    spec.shape = turned(box(Vec3(1, 1, 2), Vec3(2, 2, 3)));
    spec.faces = {{0, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())},
                  {1, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())}};
    const auto far = makeTool(target, spec);
    ASSERT_FALSE(far);
    EXPECT_EQ(errcName(far.error().code), "contradiction");
    EXPECT_NE(far.error().message.find("Corner 4"), std::string::npos) << far.error().message;
    spec.faces = {{0, ToolFaceRule::Kind::InFace, faceTowards(target, Vec3::UnitZ())},
                  {0, ToolFaceRule::Kind::ParallelToFace, faceTowards(target, Vec3::UnitX())}};
    const auto both = makeTool(target, spec);
    ASSERT_FALSE(both);
    EXPECT_EQ(errcName(both.error().code), "contradiction");
    EXPECT_NE(both.error().message.find("Face 0"), std::string::npos) << both.error().message;
}

TEST(ExactTool, BadRulesAreRefused) {
    const Solid target = turnedBox();
    const PolyhedronSpec shape = box(Vec3::Zero(), Vec3::Ones());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<ToolSpec> bad(8);
    for (ToolSpec& spec : bad) spec.shape = shape;
    bad[0].faces = {{6, ToolFaceRule::Kind::InFace, 0}};
    bad[1].faces = {{0, ToolFaceRule::Kind::InFace, 6}};
    bad[2].faces = {{0, ToolFaceRule::Kind::AlongEdge, -1}};
    bad[3].vertices = {{8, ToolVertexRule::Kind::AtVertex, 0, -1, 0.0}};
    bad[4].vertices = {{0, ToolVertexRule::Kind::OnEdge, 12, -1, 0.0}};
    bad[5].vertices = {{0, ToolVertexRule::Kind::BetweenVertices, 0, 1, nan}};
    bad[6].edges = {{{0, 6}, ToolEdgeRule::Kind::AlongNormal, 0}};  // a diagonal
    bad[7].shape.vertices[3].x() = nan;
    for (std::size_t i = 0; i < bad.size(); ++i) {
        const auto tool = makeTool(target, bad[i]);
        ASSERT_FALSE(tool) << i;
        EXPECT_EQ(errcName(tool.error().code), "bad-value") << i << tool.error().message;
    }
}

}  // namespace
}  // namespace ew::test
