// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/whole_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/solid/visibility.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool isReadable(const WholeCase& drawn) {
    SketchCase sketch;
    std::vector<Vec2> ends;
    for (const Line2& line : drawn.lines) {
        VisibleEdge edge;
        edge.line = line;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto known = std::find_if(ends.begin(), ends.end(), [&](const Vec2& p) {
                return (p - line[k]).norm() < 1e-6;
            });
            edge.vertices[k] = static_cast<int>(known - ends.begin());
            if (known == ends.end()) ends.push_back(line[k]);
        }
        sketch.drawing.edges.push_back(edge);
    }
    // An end that no other line shares is a T junction.
    std::vector<int> lines(ends.size(), 0);
    for (const VisibleEdge& e : sketch.drawing.edges) {
        for (const int v : e.vertices) ++lines[at(v)];
    }
    for (VisibleEdge& e : sketch.drawing.edges) {
        for (int& v : e.vertices) {
            if (lines[at(v)] == 1) v = -1;
        }
    }
    ReadabilityRules rules;
    rules.fewestFaces = 0;
    return unreadableBecause(sketch, rules).empty();
}

int wellSeenFaces(const Solid& solid, const OrthographicCamera& camera) {
    int count = 0;
    for (const SolidFace& f : solid.faces()) {
        if (-f.normal.dot(camera.direction) > 0.15) ++count;
    }
    return count;
}

bool showsItsParts(const Solid& solid, const OrthographicCamera& camera) {
    std::vector<int> group(solid.vertices().size());
    for (std::size_t v = 0; v < group.size(); ++v) group[v] = static_cast<int>(v);
    const auto find = [&](int v) {
        while (group[at(v)] != v) v = group[at(v)];
        return v;
    };
    for (const SolidEdge& e : solid.edges()) {
        if (!e.convex) group[at(find(e.ends[0]))] = find(e.ends[1]);
    }
    std::map<int, bool> seen;
    for (const SolidEdge& e : solid.edges()) {
        if (!e.convex) seen[find(e.ends[0])] = false;
    }
    const auto view = SolidView::make(solid, Pose{}, camera);
    for (const VisiblePiece& piece : view->visiblePieces()) {
        const SolidEdge& e = solid.edges()[at(piece.edge)];
        if (!e.convex && !piece.point) seen[find(e.ends[0])] = true;
    }
    return std::all_of(seen.begin(), seen.end(), [](const auto& part) { return part.second; });
}

bool showsItsFaces(const Solid& solid, const OrthographicCamera& camera) {
    const auto view = SolidView::make(solid, Pose{}, camera);
    std::vector<bool> seen(solid.faces().size(), false);
    for (const SolidTriangle& t : solid.triangles()) {
        // Points of a grid within the triangle.
        constexpr int kSteps = 8;
        for (int i = 1; i < kSteps && !seen[at(t.face)]; ++i) {
            for (int j = 1; i + j < kSteps; ++j) {
                const double u = static_cast<double>(i) / kSteps;
                const double v = static_cast<double>(j) / kSteps;
                const Vec2 p = (1.0 - u - v) * view->points()[at(t.vertices[0])] +
                               u * view->points()[at(t.vertices[1])] +
                               v * view->points()[at(t.vertices[2])];
                const auto pick = view->pick(p);
                if (pick && pick->face == t.face) seen[at(t.face)] = true;
            }
        }
    }
    for (std::size_t f = 0; f < seen.size(); ++f) {
        if (view->facing(static_cast<int>(f)) == Facing::Front && !seen[f]) return false;
    }
    return true;
}

bool showsItsCorners(const Solid& solid, const OrthographicCamera& camera) {
    constexpr double kStraightDeg = 12.0;
    constexpr double kStraightPx = 10.0;
    for (const SolidFace& f : solid.faces()) {
        if (f.normal.dot(camera.direction) > 0.0) continue;
        for (const std::vector<int>& loop : f.loops) {
            const std::size_t n = loop.size();
            for (std::size_t k = 0; k < n; ++k) {
                const auto p = [&](std::size_t i) {
                    return camera.project(solid.vertices()[at(loop[i % n])]);
                };
                const Vec2 in = p(k + 1) - p(k);
                const Vec2 out = p(k + 2) - p(k + 1);
                const double turn = std::abs(std::atan2(cross2(in, out), in.dot(out)));
                const double height = std::abs(cross2(in, in + out)) / (in + out).norm();
                if (turn < kStraightDeg / 360.0 * kTurn || height < kStraightPx) return false;
            }
        }
    }
    return true;
}

bool hasSliver(const Solid& solid, const OrthographicCamera& camera) {
    return std::any_of(solid.faces().begin(), solid.faces().end(), [&](const SolidFace& f) {
        return std::abs(f.normal.dot(camera.direction)) < 0.08;
    });
}

}  // namespace ew::test
