// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/box_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t kMostFaces = 4;
constexpr std::size_t kMostTurns = 2;  ///< of the axes on one face
constexpr double kLeastShare = 0.06;   ///< of the ink that lies on a face
constexpr double kLeastSeen = 0.2;     ///< sine of an axis to the view
constexpr double kMostTurnDeg = 35.0;  ///< of a short line from its axis

/// Faces that ink lies on, most of it first.
std::vector<int> facesWithInk(const InkReading& ink, const ModelView& model) {
    std::map<int, double> px;
    double all = 0;
    for (const Segment& s : ink.segments) {
        constexpr int kAsked = 9;
        for (int i = 0; i < kAsked; ++i) {
            const double share = (i + 0.5) / kAsked;
            const double part = s.inkPx / kAsked;
            all += part;
            if (const auto f = model.faceAt((1 - share) * s.a + share * s.b)) px[*f] += part;
        }
    }
    std::vector<std::pair<double, int>> order;
    for (const auto& [f, n] : px) {
        if (n >= kLeastShare * all && model.view().facing(f) == Facing::Front) {
            order.emplace_back(-n, f);
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<int> faces;
    for (const auto& [n, f] : order) {
        if (faces.size() < kMostFaces) faces.push_back(f);
    }
    return faces;
}

/// Directions of a face's edges up to a quarter turn, those with the longest edges first.
std::vector<Vec3> turnsOf(int face, const ModelView& model, const Vec3& normal) {
    std::vector<std::pair<double, Vec3>> found;
    for (const int e : model.edgesOf(face)) {
        const Vec3 d = model.edgeDirection(e);
        const auto& ends = model.solid().edges()[at(e)].ends;
        const double length = (model.vertex(ends[1]) - model.vertex(ends[0])).norm();
        const auto known = std::find_if(found.begin(), found.end(), [&](const auto& k) {
            return k.second.cross(d).norm() < tol::kSolidDirection ||
                   normal.cross(k.second).cross(d).norm() < tol::kSolidDirection;
        });
        if (known == found.end()) {
            found.emplace_back(length, d);
        } else {
            known->first += length;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Vec3> turns;
    for (const auto& [length, d] : found) {
        if (turns.size() < kMostTurns) turns.push_back(d);
    }
    return turns;
}

bool setAxes(BoxFrame& frame, const Vec3& u, const Vec3& normal) {
    frame.axis = {u, normal.cross(u).normalized(), normal};
    for (std::size_t a = 0; a < 3; ++a) {
        const Vec2 s = frame.axis[a].head<2>();
        frame.seen[a] = s.norm();
        if (frame.seen[a] < kLeastSeen) return false;
        frame.screen[a] = s / frame.seen[a];
    }
    // Two axes that look alike cannot be told apart.
    for (std::size_t a = 0; a < 3; ++a) {
        if (std::abs(cross2(frame.screen[a], frame.screen[(a + 1) % 3])) < kLeastSeen) return false;
    }
    return true;
}

/// What of the solid is seen within this distance of the ink, of all that is drawn and may be.
std::vector<std::array<Vec2, 2>> linesNear(const InkReading& ink, const ModelView& model,
                                           double distancePx) {
    Eigen::AlignedBox2d reach;
    for (const Segment& s : ink.segments) reach.extend(s.a).extend(s.b);
    const Vec2 more = Vec2::Constant(distancePx + 0.5 * reach.diagonal().norm());
    reach.min() -= more;
    reach.max() += more;
    std::vector<std::array<Vec2, 2>> lines;
    for (const std::size_t i : model.piecesNear(reach)) {
        if (!model.pieces()[i].point) lines.push_back(model.pieces()[i].px);
    }
    return lines;
}

void setBorder(BoxFrame& frame, const ModelView& model) {
    for (auto& b : frame.border)
        b = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const int v : model.solid().faces()[at(frame.face)].loops.front()) {
        const Vec3 p = model.vertex(v) - frame.origin;
        for (std::size_t a = 0; a < 2; ++a) {
            frame.border[a][0] = std::min(frame.border[a][0], p.dot(frame.axis[a]));
            frame.border[a][1] = std::max(frame.border[a][1], p.dot(frame.axis[a]));
        }
    }
}

BoxLine lineIn(const BoxFrame& frame, const Segment& s, const Thresholds& thresholds,
               double noisePx) {
    BoxLine l;
    l.segment = &s;
    l.length = (s.b - s.a).norm();
    const Vec2 d = (s.b - s.a) / std::max(l.length, 1e-9);
    constexpr double kDegree = std::numbers::pi / 180.0;
    double least = std::sin(std::min(
        kMostTurnDeg * kDegree,
        thresholds.angleDeg * kDegree + std::atan(2.0 * noisePx / std::max(l.length, 1.0))));
    for (std::size_t a = 0; a < 3; ++a) {
        const double sine = std::abs(cross2(frame.screen[a], d));
        if (sine >= least) continue;
        least = sine;
        l.axis = static_cast<int>(a);
    }
    if (l.axis < 0) return l;
    const auto axis = static_cast<std::size_t>(l.axis);
    const Vec2 o = frame.origin.head<2>();
    l.offset = cross2(frame.screen[axis], 0.5 * (s.a + s.b) - o);
    l.from = (s.a - o).dot(frame.screen[axis]);
    l.to = (s.b - o).dot(frame.screen[axis]);
    if (l.from > l.to) std::swap(l.from, l.to);
    return l;
}

}  // namespace

double BoxFrame::across(std::size_t a, std::size_t other) const {
    return seen[other] * cross2(screen[a], screen[other]);
}

double BoxFrame::along(std::size_t a, std::size_t other) const {
    return seen[other] * screen[a].dot(screen[other]);
}

Vec2 BoxFrame::acrossOf(std::size_t a) const { return {-screen[a].y(), screen[a].x()}; }

double BoxFrame::modelDistance(const Vec2& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& l : modelLines) least = std::min(least, distanceToSegment(p, l[0], l[1], 0.0));
    return least;
}

std::array<Vec2, 2> BoxFrame::inked(const std::vector<std::size_t>& which, const Vec2& a,
                                    const Vec2& b) const {
    const Vec2 u = (b - a).normalized();
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (const std::size_t i : which) {
        for (const Vec2& p : {lines[i].segment->a, lines[i].segment->b}) {
            lo = std::min(lo, (p - a).dot(u));
            hi = std::max(hi, (p - a).dot(u));
        }
    }
    const double length = (b - a).norm();
    return {Vec2(a + std::clamp(lo, 0.0, length) * u), Vec2(a + std::clamp(hi, 0.0, length) * u)};
}

GraphEdge BoxFrame::fitted(const std::vector<std::size_t>& which, const Vec2& a,
                           const Vec2& b) const {
    InkLine line;
    std::set<int> strokes;
    const Vec2 u = (b - a).normalized();
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (const std::size_t i : which) {
        const Segment& s = *lines[i].segment;
        line.points.insert(line.points.end(), s.points.begin(), s.points.end());
        strokes.insert(s.stroke);
        for (const Vec2& p : {s.a, s.b}) {
            const double t = (p - a).dot(u);
            if (t < lo) line.a = p;
            if (t > hi) line.b = p;
            lo = std::min(lo, t);
            hi = std::max(hi, t);
        }
    }
    line.strokes.assign(strokes.begin(), strokes.end());
    line.inkPx = line.length();
    return fitEdge(a, b, {{0, 0.0, line.length()}}, {line});
}

std::vector<BoxFrame> boxFrames(const InkReading& ink, const ModelView& model,
                                const Thresholds& thresholds, double noisePx) {
    Eigen::AlignedBox2d extent;
    for (std::size_t v = 0; v < model.solid().vertices().size(); ++v) {
        extent.extend(Vec2(model.vertex(static_cast<int>(v)).head<2>()));
    }
    const auto modelLines = linesNear(ink, model, thresholds.distancePx);
    std::vector<BoxFrame> frames;
    for (const int face : facesWithInk(ink, model)) {
        const Vec3 normal = model.plane(face).normal;
        for (const Vec3& u : turnsOf(face, model, normal)) {
            BoxFrame frame;
            frame.face = face;
            frame.modelLines = modelLines;
            frame.sizePx = extent.diagonal().norm();
            frame.origin = model.vertex(model.solid().faces()[at(face)].loops.front().front());
            if (!setAxes(frame, u, normal)) continue;
            setBorder(frame, model);
            for (const Segment& s : ink.segments) {
                BoxLine l = lineIn(frame, s, thresholds, noisePx);
                for (const double share : {0.15, 0.5, 0.85}) {
                    l.modelOff =
                        std::max(l.modelOff, frame.modelDistance((1 - share) * s.a + share * s.b));
                }
                frame.lines.push_back(l);
            }
            frames.push_back(std::move(frame));
        }
    }
    return frames;
}

}  // namespace ew
