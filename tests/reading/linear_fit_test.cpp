// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/linear_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/tlib/library.h"

namespace ew::test {
namespace {

struct Shipped {
    const Template& tmpl;
    TemplateAnalysis analysis;
};
Shipped shipped(const std::string& id) {
    static const TemplateLibrary library =
        loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates")->library;
    const Template& tmpl = library.at(static_cast<std::size_t>(library.find(id)));
    return {tmpl, analyse(tmpl)};
}

/// The direction class of the edge between two vertices.
std::size_t classOf(const Shipped& s, int a, int b) {
    const int e = s.analysis.edgeBetween(a, b);
    return static_cast<std::size_t>(s.analysis.edges[static_cast<std::size_t>(e)].directionClass);
}

/// What a camera along z sees of some edges of a shape whose picture is exact.
Sighting seen(const Shipped& s, const CameraPoints& points) {
    Sighting out;
    out.vertexPx.resize(points.size());
    out.seen.assign(points.size(), true);
    for (std::size_t v = 0; v < points.size(); ++v) out.vertexPx[v] = points[v].head<2>();
    for (std::size_t e = 0; e < s.analysis.edges.size(); ++e) {
        const auto& ends = s.analysis.edges[e].ends;
        DrawnEdge d;
        d.edge = static_cast<int>(e);
        d.vertex = ends;
        d.tips = {points[static_cast<std::size_t>(ends[0])].head<2>(),
                  points[static_cast<std::size_t>(ends[1])].head<2>()};
        out.edges.push_back(d);
    }
    out.sizePx = 100.0;
    return out;
}

/// A shape turned so that no edge is seen end-on, some 50 px wide.
CameraPoints turned(const PolyhedronSpec& shape, const Mat3& turn) {
    CameraPoints points;
    for (const Vec3& v : shape.vertices) points.push_back(turn * (50.0 * v) + Vec3(600, 400, 20));
    return points;
}

const Mat3 kTurn = Eigen::AngleAxisd(0.8, Vec3(1, 0.7, -0.4).normalized()).toRotationMatrix();

KnownDirections directionsOf(const Shipped& s, const CameraPoints& points) {
    KnownDirections known(static_cast<std::size_t>(s.analysis.classCount));
    for (const AnalysedEdge& e : s.analysis.edges) {
        known[static_cast<std::size_t>(e.directionClass)] =
            (points[static_cast<std::size_t>(e.ends[1])] -
             points[static_cast<std::size_t>(e.ends[0])])
                .normalized();
    }
    return known;
}

Anchors standing(const CameraPoints& points, const std::vector<int>& face) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(face[i])]; };
    const Vec3 n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    Anchors anchors;
    for (const int v : face) {
        const Vec3& p = points[static_cast<std::size_t>(v)];
        anchors.planes.push_back({v, n, n.dot(p), p.head<2>()});
    }
    return anchors;
}

void expectPoints(const GeneralSolution& s, const CameraPoints& truth) {
    ASSERT_EQ(s.points.size(), truth.size());
    for (std::size_t v = 0; v < truth.size(); ++v) {
        EXPECT_LT((s.points[v] - truth[v]).norm(), 1e-8);
    }
}

TEST(LinearFit, GivenAllDirectionsEveryShippedTemplateComesBack) {
    for (const char* id :
         {"cube", "triangular-prism", "triangular-pyramid", "wedge-frustum", "l-prism"}) {
        SCOPED_TRACE(id);
        const Shipped s = shipped(id);
        const CameraPoints points = turned(s.tmpl.shape, kTurn);
        const KnownDirections known = directionsOf(s, points);
        ASSERT_TRUE(isLinear(s.tmpl, s.analysis, known));
        const auto fit = solveLinearly(s.tmpl, s.analysis, seen(s, points),
                                       standing(points, s.tmpl.shape.faces[0]), known);
        ASSERT_TRUE(fit);
        EXPECT_EQ(fit->freedoms, 0);
        expectPoints(*fit, points);
    }
}

TEST(LinearFit, ThePrismsTriangleMayTurnFreelyAcrossItsLength) {
    const Shipped s = shipped("triangular-prism");
    const CameraPoints points = turned(s.tmpl.shape, kTurn);
    KnownDirections known = directionsOf(s, points);
    // Length and one side of the triangle are told; the two other sides follow from the ink.
    const auto& triangle =
        s.tmpl.shape.faces[0].size() == 3 ? s.tmpl.shape.faces[0] : s.tmpl.shape.faces[1];
    known[classOf(s, triangle[1], triangle[2])].reset();
    known[classOf(s, triangle[2], triangle[0])].reset();
    ASSERT_TRUE(isLinear(s.tmpl, s.analysis, known));
    const std::vector<int>* side = nullptr;
    for (const auto& f : s.tmpl.shape.faces) {
        if (f.size() == 4) side = &f;
    }
    const auto fit =
        solveLinearly(s.tmpl, s.analysis, seen(s, points), standing(points, *side), known);
    ASSERT_TRUE(fit);
    expectPoints(*fit, points);
}

TEST(LinearFit, TheMedianOfATriangleStandsWhereItIsToldTo) {
    const Shipped s = shipped("triangular-prism");
    const CameraPoints points = turned(s.tmpl.shape, kTurn);
    KnownDirections known = directionsOf(s, points);
    // Base 0-1 and 3-4, apexes 2 and 5: both slopes are free.
    known[classOf(s, 1, 2)].reset();
    known[classOf(s, 2, 0)].reset();
    Anchors anchors = standing(points, {0, 1, 4, 3});
    const Vec3 up = anchors.planes.front().normal;
    // The apexes were drawn aside of the middle.
    CameraPoints drawn = points;
    const Vec3 aside = 6.0 * (points[1] - points[0]).normalized();
    drawn[2] += aside;
    drawn[5] += aside;
    const auto lean = solveLinearly(s.tmpl, s.analysis, seen(s, drawn), anchors, known);
    ASSERT_TRUE(lean);
    EXPECT_LT((lean->points[2] - drawn[2]).norm(), 1e-8);
    anchors.medians = {{2, {0, 1}, up}, {5, {3, 4}, up}};
    const auto even = solveLinearly(s.tmpl, s.analysis, seen(s, drawn), anchors, known);
    ASSERT_TRUE(even);
    EXPECT_EQ(even->parameters, lean->parameters - 1);
    for (const auto& m : anchors.medians) {
        const auto at = [&](int v) { return even->points[static_cast<std::size_t>(v)]; };
        const Vec3 median = at(m.apex) - 0.5 * (at(m.base[0]) + at(m.base[1]));
        EXPECT_LT(median.cross(up).norm(), 1e-8);
        EXPECT_GT(median.norm(), 10.0);
    }
}

TEST(LinearFit, ABoxThatMayTurnAsItLikesIsNotLinear) {
    const Shipped s = shipped("cube");
    EXPECT_FALSE(isLinear(s.tmpl, s.analysis,
                          KnownDirections(static_cast<std::size_t>(s.analysis.classCount))));
}

TEST(LinearFit, AnchorsThatContradictEachOtherHaveNoSolution) {
    const Shipped s = shipped("cube");
    const CameraPoints points = turned(s.tmpl.shape, kTurn);
    const KnownDirections known = directionsOf(s, points);
    Anchors anchors = standing(points, s.tmpl.shape.faces[0]);
    anchors.points.push_back({s.tmpl.shape.faces[0][0], points[0] + Vec3(0, 0, 30)});
    EXPECT_FALSE(solveLinearly(s.tmpl, s.analysis, seen(s, points), anchors, known));
}

TEST(LinearFit, WhatTheInkDoesNotTellIsCountedAndClosed) {
    const Shipped s = shipped("cube");
    const CameraPoints points = turned(s.tmpl.shape, kTurn);
    const KnownDirections known = directionsOf(s, points);
    Sighting some = seen(s, points);
    // Only one face was drawn: nothing says how deep the box is.
    const auto& face = s.tmpl.shape.faces[0];
    std::erase_if(some.edges, [&](const DrawnEdge& d) {
        return std::find(face.begin(), face.end(), d.vertex[0]) == face.end() ||
               std::find(face.begin(), face.end(), d.vertex[1]) == face.end();
    });
    const auto fit = solveLinearly(s.tmpl, s.analysis, some, standing(points, face), known);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->freedoms, 1);
    for (const int v : face) {
        const auto i = static_cast<std::size_t>(v);
        EXPECT_LT((fit->points[i] - points[i]).norm(), 1e-8);
    }
    for (const AnalysedEdge& e : s.analysis.edges) {
        const double length = (fit->points[static_cast<std::size_t>(e.ends[1])] -
                               fit->points[static_cast<std::size_t>(e.ends[0])])
                                  .norm();
        EXPECT_GT(length, 10.0);
        EXPECT_LT(length, 100.0);
    }
}

}  // namespace
}  // namespace ew::test
